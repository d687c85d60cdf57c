// Looks for paths of more and more clearance by two kinds of work side by side: elastic bands widen the paths found so far,
// and planners look for other ways around obstacles, by motions that keep more than the best path does.
#pragma once

#include <ompl/base/PlannerData.h>
#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/geometric/PathGeometric.h>

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "clearway/planning/motion_validator.h"
#include "planning/paths/unwind.h"

namespace clearway::planning {

struct FloorSearchOptions {
    double range = 0;          ///< longest edge of the planners' trees; 0: OMPL's
    unsigned int threads = 2;  ///< >= 1
    double most = 0;           ///< no path has more clearance; finite
    double enough = 0;         ///< more is not looked for
    /// Planners first look for a few ways beside the narrow places of the best one. Then half of their time goes to ways that
    /// wind less than the best path, instead of to wider ones.
    bool wantsShortWays = false;
};

class FloorSearch {
  public:
    /// The space information's validity checker must be one of clearway's. definition: start and goal.
    FloorSearch(ompl::base::SpaceInformationPtr si, ompl::base::ProblemDefinitionPtr definition,
                std::shared_ptr<const MotionValidator> validator);
    ~FloorSearch();

    /// Whether the search is for this definition. Starts that were added to it count from the next run() on.
    bool isFor(const ompl::base::ProblemDefinitionPtr& definition) const { return definition_ == definition; }

    /// A path to widen. seconds: what it took to find it.
    void add(const WidePath& path, double seconds);

    /// Goes on until isSpent returns true or the best path keeps enough. It is called often, from several threads.
    void run(const FloorSearchOptions& options, const std::function<bool()>& isSpent);

    /// The path of most clearance, if any was found.
    const std::optional<WidePath>& best() const { return best_; }

    /// The best path by isBetterWay(): it may keep a little less clearance than best() where it winds less.
    const std::optional<WidePath>& bestWay() const;

    /// How much clearance the best path keeps; nothing before there is one. May be called while run() goes on.
    std::optional<double> clearance() const;

    /// Whether a band has widened a second path. May be called while run() goes on.
    bool hasWidenedSeveral() const;

    /// The trees of the planners that looked in vain for a first path, or else the best way, as one branch. The states live
    /// until the next run().
    void getPlannerData(ompl::base::PlannerData& data) const;

  private:
    struct Job;
    class Seeker;

    /// Planners that look for ways of one kind, wide or short ones.
    struct Seeks {
        int begun = 0;
        double patience = 0;  ///< seconds of the next one
        double spent = 0;     ///< seconds
    };

    void work();
    Job nextJob();
    Job seekingJob();
    void widen(const Job& job);
    double shortenFirst(const Job& job, ompl::geometric::PathGeometric& path) const;
    void seek(const Job& job);
    void widenLater(const WidePath& path, double seconds, bool isShortWay);
    void takeIfBetter(const WidePath& path, double gain);
    bool isTooLong(const ompl::geometric::PathGeometric& path) const;
    double radius() const;
    bool isOver() const;

    ompl::base::SpaceInformationPtr si_;
    ompl::base::ProblemDefinitionPtr definition_;
    std::shared_ptr<const MotionValidator> validator_;
    FloorSearchOptions options_;
    std::function<bool()> isSpent_;

    std::vector<std::unique_ptr<Seeker>> inVain_;  ///< they looked for a first path

    mutable std::mutex mutex_;  ///< of what follows, and of inVain_
    std::vector<Job> waiting_;  ///< paths to widen, the next one last
    std::optional<WidePath> best_;
    std::optional<WidePath> shortWay_;  ///< the best of the short ways, by isBetterWay
    double gain_ = 0;                   ///< of the best path's next band; 0: its first one is not over
    int widening_ = 0;                  ///< threads
    int ways_ = 0;                      ///< widened, ever
    int paths_ = 0;                     ///< that seekers found, ever
    Seeks wideSeeks_, shortSeeks_;
    double share_ = 0;    ///< of the difference between the best and the most clearance, for the next floor
    double widened_ = 0;  ///< seconds spent
};

}  // namespace clearway::planning
