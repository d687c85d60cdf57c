// The one place where an OMPL state becomes a pose of the part.
#pragma once

#include <ompl/base/StateSpace.h>

#include <functional>

#include "clearway/types.h"

/// @namespace clearway::planning
/// The classes for OMPL: checkers, validators, objectives, samplers, planners, and whole plans.

#pragma GCC visibility push(default)

namespace clearway::planning {

/// Returns X_environmentPart at a state. It is called from several threads at once. For a state without a
/// pose (an entry is not finite, a quaternion has norm 0) it returns a pose that is not finite, which every
/// checker here answers as invalid.
using StateToPose = std::function<Pose(const ompl::base::State*)>;

/// Makes the callback for OMPL's SE(3) and SE(2), classes derived from them (Dubins, Reeds-Shepp) and
/// wrappers around them. It normalises quaternions in double, because OMPL's own have unit length only to
/// 1e-9. In SE(2) the part turns about z and keeps its z. Throws ArgumentError that names the space
/// when it is none of these: hand in a callback of your own then.
StateToPose stateToPose(const ompl::base::StateSpace& space);

}  // namespace clearway::planning

#pragma GCC visibility pop
