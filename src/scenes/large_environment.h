// The demo scene large-environment, version 1: an instrument carrier brought through a door opening to its
// place in a car body of fine sheets that follow each other in layers.
#pragma once

#include "scenes/generated_scene.h"
#include "scenes/scene_options.h"

namespace clearway {

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

}  // namespace clearway
