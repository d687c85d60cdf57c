// Moves a path away from its surroundings, state by state.
#pragma once

#include <ompl/geometric/PathGeometric.h>

#include <functional>

#include "clearway/planning/motion_validator.h"

namespace clearway::planning {

struct RaiseOptions {
    double clearance = 0;  ///< kept by all motions of the path, by MotionValidator::keepsClearance
    double enough = 0;     ///< more clearance than this is not looked for
    std::function<bool()> isSpent;
};

/// Moves the states between the first and the last by small random moves, in rounds, until rounds stop paying
/// or isSpent returns true. A state moves to where it has more clearance, if its motions still keep the
/// clearance that all motions keep. The tightest motion gets a new state where it comes closest. Returns the
/// clearance that all motions then keep, which is at least options.clearance.
double raiseClearance(ompl::geometric::PathGeometric& path, const MotionValidator& validator,
                      const RaiseOptions& options);

}  // namespace clearway::planning
