// OMPL's state space of a problem, and its states to and from those of path files.
#pragma once

#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>

#include <functional>
#include <string>

#include "clearway/problem.h"

namespace clearway::planning {

/// SE(3) or SE(2) with the position within the bounds. turnWeight: length that one unit of OMPL's rotation
/// distance (half the angle in SE(3), the angle in SE(2), in radians) counts as, in environment units.
ompl::base::StateSpacePtr makeSpace(Space kind, const Box& bounds, double turnWeight);

ompl::base::ScopedState<> toOmpl(const ompl::base::StateSpacePtr& space, Space kind, const PartState& state);
PartState fromOmpl(Space kind, const ompl::base::State* state);

/// How planners that sample valid states do it: "uniform", "gaussian", "obstacle_based", "max_clearance" or
/// "bridge_test", as OMPL.app names them, "contact_normal" or "narrow_gap", ours; "" leaves OMPL's default.
/// adjust: called with each sampler that is made, also from several threads. Throws std::invalid_argument for
/// another name.
void setSampler(ompl::base::SpaceInformation& si, const std::string& name,
                const std::function<void(ompl::base::ValidStateSampler&)>& adjust);

}  // namespace clearway::planning
