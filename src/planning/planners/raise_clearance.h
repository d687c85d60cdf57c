// Moves a path away from its surroundings, state by state.
#pragma once

#include <ompl/geometric/PathGeometric.h>

#include <functional>

#include "clearway/planning/motion_validator.h"

namespace clearway::planning {

struct RaiseOptions {
    double clearance = 0;  ///< that all motions of the path keep, by MotionValidator::keepsClearance
    double enough = 0;     ///< no more is looked for
    std::function<bool()> isSpent;
};

/// Rounds of small random moves of the states between the first and the last, until they stop paying or
/// isSpent says so. A state is moved to where it has more clearance, if its motions still keep what all of
/// them keep; where a motion comes closest it gets a state. Returns what all motions then keep, at least what
/// was given.
double raiseClearance(ompl::geometric::PathGeometric& path, const MotionValidator& validator,
                      const RaiseOptions& options);

}  // namespace clearway::planning
