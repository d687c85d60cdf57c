// Several planners for one problem, in parallel or interleaved, until one of them finds a path.
#pragma once

#include <ompl/base/Planner.h>

#include <memory>
#include <vector>

namespace clearway::planning {

class TwistSearch;

/// Runs RRTConnect, which is quick where passages are wide, and two SlidingRRTConnect, one with standoffs of its
/// default range and one with finer ones. RRTConnect restarts after runs whose lengths follow the sequence of Luby,
/// Sinclair and Zuckerman (Optimal Speedup of Las Vegas Algorithms, 1993), because a run that has not succeeded early
/// almost never does. A TwistSearch joins them where the first start, or a goal of one state, is in a tight fit. The member with the least processor time so far runs next.
///
/// With one thread, slices of work are counted in iterations, so that one seed gives one path whatever else the
/// machine does. With more threads they are counted in time.
///
/// The solution's planner name states the member and its run. Without an exact solution the problem definition gets
/// the approximate one that comes closest. A further solve() goes on from there.
class PlannerTeam : public ompl::base::Planner {
  public:
    /// Makes a team of one thread. si: as SlidingRRTConnect takes it.
    explicit PlannerTeam(const ompl::base::SpaceInformationPtr& si);
    ~PlannerTeam() override;

    /// Makes the members. Throws as SlidingRRTConnect::setup does.
    void setup() override;

    /// Plans until there is an exact solution or isSpent is true. Goes on from the trees of a former call.
    ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition& isSpent) override;

    /// Forgets all trees.
    void clear() override;

    /// Adds the states and edges of all members' trees to `data`, as OMPL's planners do.
    void getPlannerData(ompl::base::PlannerData& data) const override;

    /// Sets the longest edge of RRTConnect's trees, in OMPL's distance; 0: OMPL's default.
    void setRange(double range) { range_ = range; }
    /// The value that setRange was given; 0 at first.
    double getRange() const { return range_; }

    /// Sets how many members run at a time, > 0. There are at least three members, and no fewer than threads.
    void setThreads(unsigned int threads) { threads_ = threads; }
    /// How many members run at a time.
    unsigned int getThreads() const { return threads_; }

    /// The member for tight fits; null where there is none.
    const TwistSearch* twistSearch() const;

  private:
    struct Member;
    class Turns;

    void makeMembers();
    void addTwistSearch();

    double range_ = 0;
    unsigned int threads_ = 1;
    std::vector<std::unique_ptr<Member>> members_;
};

}  // namespace clearway::planning
