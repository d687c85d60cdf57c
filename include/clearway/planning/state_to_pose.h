// The one place where an OMPL state becomes a pose of the part.
#pragma once

#include <ompl/base/StateSpace.h>

#include <functional>

#include "clearway/types.h"

namespace clearway::planning {

/// X_environmentPart at a state. Called from several threads at once. A state that has no pose (an entry is
/// not finite, a quaternion of norm 0) gives a pose that is not finite, which every checker here answers as
/// invalid.
using StateToPose = std::function<Pose(const ompl::base::State*)>;

/// For OMPL's SE(3) and SE(2), classes derived from them (Dubins, Reeds-Shepp) and wrappers around them. A
/// quaternion is normalised in double: OMPL's own are of unit length only to 1e-9. In SE(2) the part turns
/// about z and keeps its z. Throws std::invalid_argument that names the space when it is none of these: then
/// hand in a callback of your own.
StateToPose stateToPose(const ompl::base::StateSpace& space);

}  // namespace clearway::planning
