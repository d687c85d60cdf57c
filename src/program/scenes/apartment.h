// The demo scene apartment, version 1: the piano mover's problem. A piano stands in a living room and is to
// come through two doors and a corridor into the music room.
#pragma once

#include "program/scenes/generated_scene.h"
#include "program/scenes/scene_options.h"

namespace clearway::scenes {

constexpr SceneOptions kApartment{1, 3000, 8000, 60};  // clearance 5 to 70 mm

/// Millimetres, closed solids, all coordinates representable in float. Walls with doors, frames and
/// furniture, their names begin with the room's; there is no ceiling, but the problem's volume leaves no room
/// to pass over walls. The piano, 1500 long and 600 deep, goes through both doors lengthwise, where it has
/// the clearance on either side and no more than a tenth as much again, and turns in the corridor.
/// problem.step is half a door leaf's thickness.
///
/// Throws std::invalid_argument, naming the option, its value and what was expected, when the clearance is
/// out of range or a number of triangles is less than the furniture needs, or above 4 million.
GeneratedScene makeApartment(const SceneOptions& options);

}  // namespace clearway::scenes
