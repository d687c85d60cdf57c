// The table of the demo scenes. A name ends with a version: what a version makes from its options never
// changes, a better scene is a new row beside it.
#pragma once

#include <string>
#include <vector>

#include "program/scenes/generated_scene.h"
#include "program/scenes/replay.h"
#include "program/scenes/scene_options.h"

namespace clearway::scenes {

struct NamedScene {
    const char* name;   ///< with its version: "tunnel-console-1"
    const char* about;  ///< one line, for lists
    SceneOptions defaults;
    /// Throws std::invalid_argument, naming the option, its value and what was expected, when the scene
    /// cannot be made so.
    GeneratedScene (*make)(const SceneOptions& options);
    Replay replay{};              ///< what its benchmarks are like
    const char* preview = "iso";  ///< the view its picture is taken in
};

const std::vector<NamedScene>& namedScenes();

/// The scene of that name; a name without version means the newest. Throws std::invalid_argument that lists
/// the names.
const NamedScene& sceneNamed(const std::string& name);

}  // namespace clearway::scenes
