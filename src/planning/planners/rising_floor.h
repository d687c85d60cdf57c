// A planner for least clearance: it plans for a path, then for a path that keeps more clearance, and so on.
// Motions that keep a floor are found as quickly as others until the floor leaves little clearance. Planners that
// ask an objective for the cost of each motion see far fewer motions in the same time.
#pragma once

#include <ompl/base/Planner.h>
#include <ompl/geometric/PathGeometric.h>

#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include "clearway/planning/motion_validator.h"
#include "planning/planners/floor_search.h"
#include "planning/planners/planner_team.h"

namespace clearway::planning {

/// First a PlannerTeam looks for a path. The path is shortened, and an elastic band widens it (see widenPath). The band never changes
/// the way around obstacles, so other threads look for other ways meanwhile (see FloorSearch): for paths that keep a floor, a third
/// of the way from the clearance of the best path to the most that start and goal leave. When such a search finds nothing in the
/// time of some earlier ones, the next floor is half as far up, and so on. Some of the first few ways are sought beside the
/// narrow places of the best path, and some with a lower floor, because bands widen some ways further than others.
///
/// RisingFloor plans by certified motions, whatever validator the space information has, in the scene of the
/// space information's validity checker, which must be one of clearway's: see sceneOf. The problem definition
/// gets the best path when the time is over. A further solve() goes on from there. The progress property "best cost REAL" is
/// the clearance that the best path keeps so far; it never falls.
class RisingFloor : public ompl::base::Planner {
  public:
    explicit RisingFloor(const ompl::base::SpaceInformationPtr& si);
    ~RisingFloor() override;

    /// Throws ArgumentError as sceneOf does, and as MotionValidator.
    ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition& isSpent) override;
    void clear() override;
    /// The trees of the team that looks for a first path, or else the best way, as one branch.
    void getPlannerData(ompl::base::PlannerData& data) const override;

    struct First {
        double clearance = 0;  ///< that all motions of the path keep
        double seconds = 0;    ///< that it took to find the path
    };
    /// Lets the next solve() begin with the band of a path from start to goal, whose motions are valid.
    void startFrom(const ompl::geometric::PathGeometric& path, const First& first);

    /// How much the best path keeps so far; nothing before there is one. May be called while solve() goes on.
    std::optional<double> clearance() const;

    /// Whether a band has widened a second path. May be called while solve() goes on.
    bool hasWidenedSeveral() const;

    /// After a few ways looks for ways that wind less, too. Ends with one that keeps nearly as much clearance as the best path:
    /// see FloorSearch::bestPath.
    void lookForShortPaths() { wantsShortPaths_ = true; }

    void setRange(double range) { range_ = range; }  ///< longest edge of the trees; 0: OMPL's
    double getRange() const { return range_; }
    void setThreads(unsigned int threads) { threads_ = threads; }  ///< how many planners run side by side
    unsigned int getThreads() const { return threads_; }

  private:
    std::shared_ptr<const FloorSearch> search() const;
    bool hasValidStart() const;
    double mostClearance() const;
    FloorSearchOptions searchOptions() const;
    void chooseValidator();
    ompl::base::PlannerStatus findFirst(const ompl::base::PlannerTerminationCondition& isSpent);

    double range_ = 0;
    bool wantsShortPaths_ = false;
    unsigned int threads_ = 2;
    std::shared_ptr<const MotionValidator> validator_;
    ompl::base::StateValidityCheckerPtr
        checker_;                          ///< for whose scene the validator was made; null: it was given
    std::shared_ptr<FloorSearch> search_;  ///< shared with those who ask for the progress
    mutable std::mutex searchMutex_;       ///< of the pointer
    std::optional<std::pair<WidePath, double>> first_;      ///< with the seconds it took
    std::shared_ptr<PlannerTeam> team_;                     ///< null before it looks for a first path
    std::shared_ptr<const MotionValidator> teamValidator_;  ///< the team's motions ask it
    double teamSeconds_ = 0;
};

}  // namespace clearway::planning
