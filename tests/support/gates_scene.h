// A small planning problem in the plane in which the shortest way is not the best: two walls, each with a
// narrow gate straight ahead and a wide one to the side.
#pragma once

#include "clearway/problem.h"
#include "clearway/scene.h"

namespace clearway::testing {

struct GatesScene {
    Scene scene;
    Problem problem;
};

/// SE(2); the part is 20 x 10 x 10. The walls, 4 thick, are at x = -30 and 30, start and goal at x = -80 and
/// 80. Through the gates straight ahead no path has a clearance above 7; through both wide gates none has one
/// above 11.
GatesScene gatesScene();

constexpr double kNarrowGates = 7;
constexpr double kWideGates = 11;

}  // namespace clearway::testing
