// Goes along a path once more and finds where the part is closest to its surroundings.
#pragma once

#include <ompl/base/ScopedState.h>
#include <ompl/geometric/PathGeometric.h>

#include <cstdint>
#include <functional>
#include <optional>

#include "clearway/planning/discrete_motion_validator.h"
#include "clearway/planning/motion_validator.h"
#include "clearway/planning/validity_checker.h"

namespace clearway::planning {

struct Walk {
    std::uint64_t states = 0;   ///< looked at
    double leastClearance = 0;  ///< of the states looked at: distance - margin, a lower bound
    double leastDistance = 0;   ///< no state looked at is closer; along the whole path when certified
    SceneDistance least;        ///< at the state looked at where it is least
    std::optional<ompl::base::ScopedState<>> where;
};

/// Looks at every state that the validator looks at on the path's motions, and refine - 1 more in each gap.
/// Nothing when one of them is invalid, a motion cannot be checked, or isStopped says so.
std::optional<Walk> walk(const ompl::geometric::PathGeometric& path, const ValidityChecker& checker,
                         const DiscreteMotionValidator& validator, int refine,
                         const std::function<bool()>& isStopped);

/// Certifies every motion of the path. Nothing when one is not, or isStopped says so.
std::optional<Walk> walkCertified(const ompl::geometric::PathGeometric& path,
                                  const MotionValidator& validator, const std::function<bool()>& isStopped);

}  // namespace clearway::planning
