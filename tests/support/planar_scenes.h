// Small planning problems in the plane, with a part of 20 x 10 x 10.
#pragma once

#include "clearway/problem.h"
#include "clearway/scene.h"

namespace clearway::testing {

struct PlanarScene {
    Scene scene;
    Problem problem;
};

/// The shortest way is not the best: two walls, 4 thick, at x = -30 and 30, have a narrow gate straight ahead and a wide one to the
/// side. Start and goal are at x = -80 and 80. Through the gates straight ahead no path has a clearance above 7; through both wide
/// gates none has one above 11.
PlanarScene gatesScene();

constexpr double kNarrowGates = 7;
constexpr double kWideGates = 11;

/// Different ways have slightly different clearances: between start and goal, at x = -100 and 100, stand posts of 5 x 5 at random
/// places, no two of them nearer than 20.
PlanarScene postsScene();

}  // namespace clearway::testing
