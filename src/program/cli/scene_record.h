// What is told about a demo scene beside its meshes: how near its path comes, poses to replay, a picture.
#pragma once

#include <string>

#include "program/scenes/scenes.h"

namespace clearway::cli {

/// The row that made the scene, and with which options.
struct SceneOrigin {
    const scenes::NamedScene& row;
    scenes::SceneOptions options;
};

/// Of a scene that writeScene wrote: audits its path, writes the replay poses and, unless it is not wanted,
/// the picture, states in the problem, the path and the poses what they keep, and prints a row about each.
/// False, with a message on stderr, when the path does not keep the clearance the scene was made with.
/// environment: as written. Throws what writing files throws.
bool recordScene(const SceneOrigin& origin, const scenes::SceneFiles& files, const Mesh& environment,
                 bool wantsPreview);

}  // namespace clearway::cli
