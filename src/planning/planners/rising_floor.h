// A planner for least clearance: it plans for a path, then for a path that keeps more clearance, and so on.
// Motions that keep a floor are found as quickly as others until the floor leaves little room. Planners that
// ask an objective for the cost of each motion see far fewer motions in the same time.
#pragma once

#include <ompl/base/Planner.h>
#include <ompl/geometric/PathGeometric.h>

#include <memory>
#include <optional>

#include "clearway/planning/motion_validator.h"

namespace clearway::planning {

/// Each round runs RRTConnect and RRT side by side until the first path. Then the path is raised (see
/// raiseClearance) for as long as the round took. The next floor is a third of the way from the clearance
/// that the path keeps to the most that start and goal leave. When a round finds no path in the time of some
/// earlier rounds, the next floor is half as far up, and so on.
///
/// RisingFloor plans by certified motions, whatever validator the space information has, in the scene of the
/// space information's validity checker, which must be one of clearway's: see sceneOf. The problem definition
/// gets the best path when the time is over. A further solve() goes on from there.
class RisingFloor : public ompl::base::Planner {
  public:
    explicit RisingFloor(const ompl::base::SpaceInformationPtr& si);

    /// Throws std::invalid_argument as sceneOf does, and as MotionValidator.
    ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition& isSpent) override;
    void clear() override;

    void setRange(double range) { range_ = range; }  ///< longest edge of the trees; 0: OMPL's
    double getRange() const { return range_; }
    void setThreads(unsigned int threads) { threads_ = threads; }  ///< how many planners run side by side
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
