// Room for a planned path, before it is shortened: clearance gained by elastic bands and by planning anew.
#pragma once

#include <ompl/geometric/PathGeometric.h>

#include <cstdint>
#include <functional>
#include <optional>

#include "planning/plan/plan_setup.h"

namespace clearway::planning {

struct WideningLimits {
    std::optional<std::uint64_t>
        sweeps;                  ///< of each band; then nothing is planned anew, and the answer is repeatable
    double planningSeconds = 0;  ///< that it took to find the path
    double range = 0;            ///< longest edge of the planners' trees
    unsigned int threads = 1;
    std::function<bool()>
        isDue;  ///< true ends the work on other ways and bands once the clearance grows slowly
    std::function<bool()> isSpent;  ///< called often, also within motions; true ends everything
};

/// Gives a valid path of certified motions as much clearance as the limits allow. Without a limit of sweeps another way
/// around obstacles may replace it. Returns the clearances that all motions keep before and after.
WideningReport widenPath(const PlanSetup& setup, ompl::geometric::PathGeometric& path,
                         const WideningLimits& limits);

}  // namespace clearway::planning
