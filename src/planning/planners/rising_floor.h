// A planner for least clearance: it plans for a path, then for a path that keeps more clearance, and so on.
// Motions that keep a floor are found as quickly as others until the floor leaves little room. Planners that
// ask an objective for the cost of each motion see far fewer motions in the same time.
#pragma once

#include <ompl/base/Planner.h>
#include <ompl/geometric/PathGeometric.h>

#include <functional>
#include <memory>
#include <optional>

#include "clearway/planning/motion_validator.h"

namespace clearway::planning {

/// Each round runs RRTConnect and RRT side by side until the first path. Then an elastic band gives the path room (see
/// makeRoomBothWays) until it no longer gains. The band never changes the way around obstacles, so the next round looks
/// for another way. Its floor is a third of the way from the clearance that the best path keeps to the most that start
/// and goal leave. When a round finds no path in the time of some earlier rounds, the best path's band goes on for as
/// long with smaller steps, and the next floor is half as far up, and so on.
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

    struct First {
        double clearance = 0;  ///< that all motions of the path keep
        double seconds = 0;    ///< that it took to find the path
    };
    /// Lets the next solve() begin with the band of a path from start to goal, whose motions are valid.
    void startFrom(const ompl::geometric::PathGeometric& path, const First& first);

    void setRange(double range) { range_ = range; }  ///< longest edge of the trees; 0: OMPL's
    double getRange() const { return range_; }
    void setThreads(unsigned int threads) { threads_ = threads; }  ///< how many planners run side by side
    unsigned int getThreads() const { return threads_; }

  private:
    struct Found {
        std::shared_ptr<ompl::geometric::PathGeometric> path;
        double clearance = 0;
        double gain = 0;  ///< the band's next steps; 0: the path had no band yet
    };
    class Round;

    bool hasValidStart() const;
    double mostClearance() const;
    double wantedClearance() const;
    bool isSatisfied(const Found& found, double most) const;
    std::optional<Found> planKeeping(double floor,
                                     const ompl::base::PlannerTerminationCondition& isSpent) const;
    void widen(Found& found, const std::function<bool()>& isSpent, double most) const;
    void takeIfBetter(Found found);
    void planAnew(const ompl::base::PlannerTerminationCondition& isSpent, double most);

    double range_ = 0;
    unsigned int threads_ = 2;
    std::shared_ptr<const MotionValidator> validator_;
    std::optional<Found> best_;
    double patience_ = 0;  ///< seconds for the next round
    double share_ = 0;     ///< of the difference between the best and the most clearance, for the next floor
};

}  // namespace clearway::planning
