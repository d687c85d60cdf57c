// A planner for least clearance: plans for a path, then for one that keeps more clearance than it, and so on.
// With a floor motions are found as quickly as without one until it leaves little room, where planners that
// ask an objective what each motion costs see but few motions.
#pragma once

#include <ompl/base/Planner.h>
#include <ompl/geometric/PathGeometric.h>

#include <memory>
#include <optional>

#include "clearway/planning/motion_validator.h"

namespace clearway::planning {

/// RRTConnect and RRT side by side, the first path of a round ends it. Then the path is raised,
/// see raiseClearance, for as long as the round took. The next floor is a third of the way from what the path
/// keeps to the most that start and goal leave; where no path is found in the time of some earlier rounds,
/// half as far up, and so on.
///
/// It plans by certified motions, whatever validator the space information has, and in the scene of its
/// validity checker, which has to be one of clearway's: see sceneOf. The problem definition gets the best
/// path when its time is over; a further solve() goes on from there.
class RisingFloor : public ompl::base::Planner {
  public:
    explicit RisingFloor(const ompl::base::SpaceInformationPtr& si);

    /// Throws std::invalid_argument as sceneOf does, and as MotionValidator.
    ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition& isSpent) override;
    void clear() override;

    void setRange(double range) { range_ = range; }  ///< longest edge of the trees; 0: OMPL's
    double getRange() const { return range_; }
    void setThreads(unsigned int threads) { threads_ = threads; }  ///< planners side by side
    unsigned int getThreads() const { return threads_; }

  private:
    struct Found {
        std::shared_ptr<ompl::geometric::PathGeometric> path;
        double clearance = 0;
    };
    class Round;

    bool hasValidStart() const;
    double mostClearance() const;
    bool isSatisfied(const Found& found, double most) const;
    std::optional<Found> planKeeping(double floor,
                                     const ompl::base::PlannerTerminationCondition& isSpent) const;
    void raise(const ompl::base::PlannerTerminationCondition& isSpent, double seconds, double most);

    double range_ = 0;
    unsigned int threads_ = 2;
    std::shared_ptr<const MotionValidator> validator_;
    std::optional<Found> best_;
    double patience_ = 0;  ///< seconds for the next round
};

}  // namespace clearway::planning
