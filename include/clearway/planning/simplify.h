// Shortens a path by cutting corners, without letting it come closer to its surroundings.
#pragma once

#include <ompl/geometric/PathGeometric.h>

#include <functional>

#include "clearway/planning/audit.h"

namespace clearway::planning {

struct SimplifyOptions {
    /// Clearance (distance - margin) that new motions keep, in environment units.
    double floor = 0;
    std::function<bool()> isSpent;  ///< asked often, also within motions; true ends the shortening
};

/// Rounds of OMPL's vertex removal and shortcuts, until they stop paying. A new motion is certified to keep
/// the floor. What then is left of stretches that did not keep it, as next to a tight start, is shortened on
/// its own by motions that keep a quarter of the floor, and so on down to the stretch's own least clearance.
/// So the least clearance of the path never falls below the floor or, where that is less, below what it was.
///
/// Returns the audit of the path as it then is. It is left as it was when not all of its motions are valid.
/// Throws std::invalid_argument when the floor is negative or not finite, the path has no state, or is one of
/// another space than the validator's.
PathAudit simplify(ompl::geometric::PathGeometric& path, const MotionValidator& validator,
                   const SimplifyOptions& options);

}  // namespace clearway::planning
