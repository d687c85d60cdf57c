// Writes a demo scene as files: its meshes, problem and path, poses to replay, and a picture.
#pragma once

#include <string>

#include "demos/scenes/scenes.h"

namespace clearway::cli {

/// The table's row and the options that made a scene.
struct SceneOrigin {
    const scenes::NamedScene& row;
    scenes::SceneOptions options;
};

/// Completes a scene that writeScene wrote. Audits the path; writes the replay poses and, if wanted, the
/// picture; records in the problem, the path and the poses how they were made and which clearance they keep;
/// prints a row about each. Returns false, with a message on stderr, when the path does not keep the
/// clearance that the scene was made with. environment: as written. Returns early when interrupted; what is
/// written is then of no use. Throws when a file cannot be written.
bool recordScene(const SceneOrigin& origin, const scenes::SceneFiles& files, const Mesh& environment,
                 bool wantsPreview);

}  // namespace clearway::cli
