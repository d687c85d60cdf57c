// Random motions of a scene: short ones, long ones, and ones to or from a place where the part almost
// touches. Some of the latter hardly turn: near the angle below which OMPL omits the turn until the end.
#pragma once

#include <ompl/base/ScopedState.h>

#include "support/motion_scene.h"

namespace clearway::testing {

struct RandomMotion {
    RandomMotion(const MotionScene& scene, Random& random);

    ompl::base::ScopedState<> s1, s2;
};

}  // namespace clearway::testing
