#include "planning/improve/widen_both_ways.h"

#include <ompl/base/ScopedState.h>

#include <algorithm>
#include <memory>

#include "clearway/planning/outside_goal.h"
#include "clearway/planning/simplify.h"
#include "planning/improve/unwind.h"

namespace clearway::planning {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

WidePath wayShortened(const og::PathGeometric& path, const MotionValidator& validator,
                      WideningOptions options) {
    WidePath way{std::make_shared<og::PathGeometric>(path), 0};
    const double floor = kClearanceBeforeBand * validator.scene().part.box().diagonal().norm();
    simplify(*way.path, validator, {std::max(floor, options.clearance), options.isSpent});
    // The shortened path keeps as much only to the audit's accuracy.
    options.clearance = 0;
    way.clearance = widenPath(*way.path, validator, options);
    return way;
}

}  // namespace

double widenBothWays(og::PathGeometric& path, const MotionValidator& validator,
                     const WideningOptions& options) {
    const WidePath shortened = wayShortened(path, validator, options);
    const double clearance = widenPath(path, validator, options);
    const double radius = 0.5 * validator.scene().part.box().diagonal().norm();
    const WidePath asItIs{std::make_shared<og::PathGeometric>(path), clearance};
    if (shortened.clearance < options.clearance || !isBetterPath(shortened, asItIs, radius)) return clearance;
    path = *shortened.path;
    return shortened.clearance;
}

void endFurtherOut(og::PathGeometric& path, const ob::GoalPtr& goal, const Scene& scene, double clearance) {
    const auto* outside = dynamic_cast<const OutsideGoal*>(goal.get());
    if (outside == nullptr) return;
    double margin = 0;
    for (const Obstacle& obstacle : scene.obstacles) margin = std::max(margin, obstacle.margin);
    ob::ScopedState<> end(path.getSpaceInformation()->getStateSpace(), path.getStates().back());
    outside->moveOut(end.get(), std::min(clearance, scene.part.box().diagonal().norm()) + margin);
    if (!path.getSpaceInformation()->equalStates(end.get(), path.getStates().back())) path.append(end.get());
}

}  // namespace clearway::planning
