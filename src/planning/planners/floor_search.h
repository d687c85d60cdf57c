// Searches for paths of more and more clearance by two kinds of work in parallel: elastic bands widen the paths found
// so far, and planners search for other paths around obstacles, by motions that keep more than the best path does.
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
#include "planning/improve/unwind.h"

namespace clearway::planning {

constexpr double kFirstShare = 0.3;  ///< of the difference between the best and the most clearance
/// Seconds of the first seeks. Beside narrow places they take far less time than the search for the first path.
constexpr double kLeastPatience = 0.05;

struct FloorSearchOptions {
    double range = 0;                               ///< longest edge of the planners' trees; 0: OMPL's
    unsigned int threads = 2;                       ///< >= 1
    double most = 0;                                ///< no path has more clearance; finite
    double enough = 0;                              ///< the search stops at this clearance
    std::function<bool(const WidePath&)> isEnough;  ///< may end the search before; null: never
    /// Once a few paths have been widened, half of the planners' time goes to paths that wind less than the best one,
    /// instead of to wider ones.
    bool wantsShortPaths = false;
};

class FloorSearch {
  public:
    /// The space information's validity checker must be one of clearway's. definition: start and goal. first: a path from one to
    /// the other, and the seconds that it took to find it.
    FloorSearch(ompl::base::SpaceInformationPtr si, ompl::base::ProblemDefinitionPtr definition,
                std::shared_ptr<const MotionValidator> validator, const WidePath& first, double seconds);
    ~FloorSearch();

    /// Whether the search is for this definition and these motions. Starts that were added to it count from the next run() on.
    bool isFor(const ompl::base::ProblemDefinitionPtr& definition,
               const std::shared_ptr<const MotionValidator>& validator) const {
        return definition_ == definition && validator_ == validator;
    }

    /// Another path to widen. seconds: what it took to find it.
    void add(const WidePath& path, double seconds);

    /// Goes on until isSpent returns true or the best path keeps enough. It is called often, from several threads.
    void run(const FloorSearchOptions& options, const std::function<bool()>& isSpent);

    /// The path of most clearance, or one that keeps a little less where it winds less: see isBetterPath().
    const WidePath& bestPath() const {
        return shortPath_ && isBetterPath(*shortPath_, best_, radius()) ? *shortPath_ : best_;
    }

    /// How much clearance the widest path keeps. May be called while run() goes on.
    double clearance() const;

    /// Whether a band has widened a second path. May be called while run() goes on.
    bool hasWidenedSeveral() const;

    /// The best way, as one branch. Its states live until the next run().
    void getPlannerData(ompl::base::PlannerData& data) const;

  private:
    struct Job;
    class Seeker;

    /// Planners that search for paths of one kind, wide or short ones.
    struct Seeks {
        int begun = 0;
        double patience = kLeastPatience;  ///< seconds of the next one
        double spent = 0;                  ///< seconds
    };

    void work();
    Job nextJob();
    Job seekingJob();
    void widen(const Job& job);
    double shortenFirst(const Job& job, ompl::geometric::PathGeometric& path) const;
    void seek(const Job& job);
    void widenLater(const WidePath& path, double seconds, bool isShortPath);
    bool isEnough(const WidePath& path) const {
        return path.clearance >= options_.enough || (options_.isEnough && options_.isEnough(path));
    }
    void takeIfBetter(const WidePath& path, double gain);
    bool isTooLong(const ompl::geometric::PathGeometric& path) const;
    double radius() const { return 0.5 * validator_->scene().part.box().diagonal().norm(); }
    bool isOver() const;

    ompl::base::SpaceInformationPtr si_;
    ompl::base::ProblemDefinitionPtr definition_;
    std::shared_ptr<const MotionValidator> validator_;
    FloorSearchOptions options_;
    std::function<bool()> isSpent_;

    mutable std::mutex mutex_;  ///< of what follows
    std::vector<Job> waiting_;  ///< paths to widen, the next one last
    WidePath best_;
    bool isEnough_ = false;              ///< the best path keeps enough
    std::optional<WidePath> shortPath_;  ///< the best of the short ways, by isBetterPath
    double gain_ = 0;                    ///< of the best path's next band; 0: its first one is not over
    int widening_ = 0;                   ///< threads
    int ways_ = 0;                       ///< widened, ever
    int paths_ = 0;                      ///< that seekers found, ever
    Seeks wideSeeks_, shortSeeks_;
    double share_ = kFirstShare;  ///< of the difference, for the next floor
    double widened_ = 0;          ///< seconds spent
};

}  // namespace clearway::planning
