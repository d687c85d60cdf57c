// The demo scene peg-in-hole, version 1: a round peg, tilted beside a block, to be put into the block's hole.
// How narrow the passage is, is its clearance.
#pragma once

#include "program/scenes/generated_scene.h"
#include "program/scenes/scene_options.h"

namespace clearway::scenes {

constexpr SceneOptions kPegInHole{1, 2000, 2000, 1};  // clearance 0.01 to 10 mm

/// Millimetres, closed solids, all coordinates representable in float. The peg, 30 mm thick with a chamfer,
/// has a head and a square drive on it; the block is 50 mm high and stands on a base. The path is straight
/// down the hole's axis once the peg has come upright over it: in the hole it leaves the clearance all round
/// and no more than a tenth as much again. problem.step is a quarter of the block's wall.
///
/// Throws std::invalid_argument, naming the option, its value and what was expected, when the clearance is
/// out of range or a number of triangles is not 300 to 4 million.
GeneratedScene makePegInHole(const SceneOptions& options);

}  // namespace clearway::scenes
