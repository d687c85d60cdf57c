// How much more a length counts the closer the part is, and the mean of that weight along a motion. A
// clearance changes no faster than the part moves, so between two poses it lies between two cones on their
// clearances. A convex weight's mean over a side of a cone is at least its value in the middle (Jensen) and
// at most the mean of its ends.
#pragma once

#include <functional>
#include <optional>

#include "planning/check/motion.h"

namespace clearway::planning {

struct ClosenessWeight {
    /// The extra weight at a clearance >= 0: convex, never rising, finite, 0 from `end` on. It is called from
    /// several threads at once.
    std::function<double(double clearance)> extra;
    double end;
};

/// Returns the mean of 1 + extra along the motion. It is off by at most the share `resolution` of itself,
/// except where that would take intervals shorter than leastInterval. Returns nothing when a pose that was
/// looked at is invalid. Throws what queries and callbacks throw.
std::optional<double> meanWeight(Motion& motion, const ClosenessWeight& weight, double resolution,
                                 double leastInterval);

}  // namespace clearway::planning
