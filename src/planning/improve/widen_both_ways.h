// Widens a path in two ways and takes the better one: of the path as it is, and of the path shortened first.
// The shortened one takes fewer states and thus less time, but may lead through a narrower gap.
#pragma once

#include <ompl/base/Goal.h>

#include "planning/improve/elastic_band.h"

namespace clearway::planning {

/// Widens as widenPath does, the shortened way first. Limits are those of each way. Returns the clearance kept. Ways that
/// keep about as much clearance are compared by windingLength().
double widenBothWays(ompl::geometric::PathGeometric& path, const MotionValidator& validator,
                     const WideningOptions& options);

/// A path that ends just outside keeps no more clearance than its end. Leads a path to an OutsideGoal on until its end has
/// the clearance, or that of a diagonal of the part's box if that is less, within the bounds. Other paths stay as they are.
void endFurtherOut(ompl::geometric::PathGeometric& path, const ompl::base::GoalPtr& goal, const Scene& scene,
                   double clearance);

}  // namespace clearway::planning
