// The demo scene boxes, version 1: a box that slides along two others, face to face. Of parallel faces at a
// gap, very many pairs of triangles are equally near. A version never changes what an option set makes; a
// better scene is a new version beside it.
#pragma once

#include "program/scenes/generated_scene.h"
#include "program/scenes/scene_options.h"

namespace clearway::scenes {

/// The clearance can be 0.01 to 20 mm.
constexpr SceneOptions kBoxes{1, 100, 700, 2};

/// The part and the environment in millimetres, all coordinates representable in float; each box a closed
/// solid whose faces are cut into grids (see gridBox) and lie in planes x, y or z = constant, exactly.
///
/// The path does not turn the part, so that its faces stay parallel to those around it: along the floor and
/// the wall at once, at a gap of `clearance` and a hundredth more, then up the wall at that gap, then away
/// from it. Numbers of triangles are reached but for three. problem.step is half the wall's thickness.
///
/// Throws std::invalid_argument, naming the option, its value and what was expected, when the clearance is
/// out of range or a number of triangles is not 12 (part) or 24 (environment) to 4 million.
GeneratedScene makeBoxes(const SceneOptions& options);

}  // namespace clearway::scenes
