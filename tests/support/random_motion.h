// Random motions of a scene: short ones, long ones, and ones to or from a place where the part is about to
// touch, of which some hardly turn: about where OMPL leaves the turn out until the end.
#pragma once

#include <ompl/base/ScopedState.h>

#include "support/motion_scene.h"

namespace clearway::testing {

struct RandomMotion {
    RandomMotion(const MotionScene& scene, Random& random);

    ompl::base::ScopedState<> s1, s2;
};

}  // namespace clearway::testing
