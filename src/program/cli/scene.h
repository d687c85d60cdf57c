// A demo scene as files: its meshes, problem and path, poses to replay, and a picture.
#pragma once

#include <string>

#include "program/scenes/scenes.h"

namespace clearway::cli {

/// The row that makes the scene, and with which options.
struct SceneOrigin {
    const scenes::NamedScene& row;
    scenes::SceneOptions options;
};

/// Completes a scene that writeScene wrote: audits its path, writes the replay poses and, if wanted, the
/// picture, records in the problem, the path and the poses how they were made and what clearance they keep,
/// and prints a row about each. Returns false, with a message on stderr, when the path does not keep the
/// clearance the scene was made with. environment: as written. Throws what writing files throws.
bool recordScene(const SceneOrigin& origin, const scenes::SceneFiles& files, const Mesh& environment,
                 bool wantsPreview);

}  // namespace clearway::cli
