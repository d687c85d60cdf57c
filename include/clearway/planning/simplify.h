// Shortens paths by cutting corners, and keeps a certified clearance.
#pragma once

#include <ompl/geometric/PathGeometric.h>

#include <functional>
#include <optional>

#include "clearway/planning/audit.h"

#pragma GCC visibility push(default)

namespace clearway::planning {

/// Options of simplify(): the clearance that it keeps, and when it ends.
struct SimplifyOptions {
    /// The clearance (distance - margin) that new motions keep, in environment units.
    double floor = 0;
    std::function<bool()> isSpent;  ///< called often, also within motions; true ends the shortening
    /// All motions of the path are known to keep this clearance; without it the path is audited first.
    std::optional<double> kept = std::nullopt;
};

/// Runs rounds of OMPL's vertex removal and shortcuts until they stop paying. Each new motion is certified to
/// keep the floor. Stretches that did not keep it before, such as those next to a tight start, are then
/// shortened on their own by motions that keep a quarter of the floor, and so on down to the stretch's own
/// least clearance. So the least clearance of the path never falls below the floor or, where that is less,
/// below the path's former least clearance.
///
/// Returns the audit of the resulting path. The path stays as it was when not all of its motions are valid.
/// Throws ArgumentError when the floor is negative or not finite, the path has no state, or the path
/// is in another space than the validator's.
PathAudit simplify(ompl::geometric::PathGeometric& path, const MotionValidator& validator,
                   const SimplifyOptions& options);

}  // namespace clearway::planning

#pragma GCC visibility pop
