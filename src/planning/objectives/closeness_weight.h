// How much more a length counts the closer the part is, and the mean of it along a motion.
// Bounds of the mean: a clearance changes no faster than the part moves, so between two poses it lies between
// two cones on their clearances; a convex weight's mean over a side of a cone is at least its value in the
// middle (Jensen) and at most the mean of its ends.
#pragma once

#include <functional>
#include <optional>

#include "planning/motion/motion.h"

namespace clearway::planning {

struct ClosenessWeight {
    /// Of a clearance >= 0: convex, never rising, finite, 0 from `end` on. Called from several threads at
    /// once.
    std::function<double(double clearance)> extra;
    double end;
};

/// The mean of 1 + extra along the motion, off by at most such a share of it, but where that would take
/// intervals shorter than leastInterval. Nothing when a pose looked at is invalid. Throws what queries and
/// callbacks throw.
std::optional<double> meanWeight(Motion& motion, const ClosenessWeight& weight, double resolution,
                                 double leastInterval);

}  // namespace clearway::planning
