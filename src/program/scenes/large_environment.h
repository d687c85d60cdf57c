// The demo scene large-environment. Version 1: an instrument carrier brought through a door opening to its
// place in a car body of fine sheets that follow each other in layers. Version 2: the tray of a sliding
// roof, drawn out between two sheets that follow it at a few millimetres. A version never changes what an
// option set makes; a better scene is a new version beside it.
#pragma once

#include "program/scenes/generated_scene.h"
#include "program/scenes/scene_options.h"

namespace clearway::scenes {

constexpr SceneOptions kLargeEnvironment{1, 100000, 1700000, 4};  // clearance 1 to 12 mm

/// The part (1.1 m wide) and the environment (3.9 x 1.6 x 1.3 m) in millimetres, all coordinates
/// representable in float, every component a closed solid.
///
/// The path begins outside the right front door opening, enters it turned a little, turns straight and moves
/// down and forward to its place, where plane pads on both sides, in front and below are at least `clearance`
/// and less than a quarter more away from it; those at the sides are as near for the last 8 cm. Before that
/// there is more room. problem.step is half the thinnest sheet.
///
/// Throws std::invalid_argument, naming the option, its value and what was expected, when the clearance is
/// out of range or a number of triangles is less than the shape needs, or above 4 million.
GeneratedScene makeLargeEnvironment(const SceneOptions& options);

constexpr SceneOptions kLargeEnvironment2{1, 120000, 1700000, 10};  // clearance 1 to 12 mm

/// The part (0.88 x 0.88 m) and the environment (3.9 x 1.6 x 1.3 m) in millimetres, all coordinates
/// representable in float, every component a closed solid.
///
/// The tray lies under the car's roof. The path begins there: to the rear along the roof's curve, between two
/// beaded sheets that follow the tray's own over all of its area, until the tray has left them behind the
/// car; then up and away. Before the tray's opening they are at least `clearance` and less than half as much
/// more away from it all along the slot, towards its edges a few millimetres more. problem.step is half the
/// thinnest sheet.
///
/// Where fewer triangles are asked for than all components have when coarsest, small ones are left out.
///
/// Throws std::invalid_argument, naming the option, its value and what was expected, when the clearance is
/// out of range or a number of triangles is less than the sheets and the tray need, or above 4 million.
GeneratedScene makeLargeEnvironment2(const SceneOptions& options);

}  // namespace clearway::scenes
