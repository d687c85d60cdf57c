// The clearance that all motions of a path keep, as the validator certifies it.
#pragma once

#include <ompl/geometric/PathGeometric.h>

#include <functional>

#include "clearway/planning/motion_validator.h"

namespace clearway::planning {

struct KeptClearanceOptions {
    double least = 0;     ///< all motions keep it; environment units, >= 0
    double most = 0;      ///< the search stops at this clearance; finite
    double share = 0.01;  ///< how much less than the largest clearance kept the answer may be
    std::function<bool()> isSpent;
    double expected = 0;  ///< probably kept, and hardly more; 0: unknown
};

/// Returns a clearance from `least` to `most` that all motions keep, by MotionValidator::keepsClearance. Clearances of a
/// millionth of `most` are as good as none. When isSpent returns true, the answer is the best one so far.
double keptClearance(const ompl::geometric::PathGeometric& path, const MotionValidator& validator,
                     const KeptClearanceOptions& options);

}  // namespace clearway::planning
