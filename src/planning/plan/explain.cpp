// Minimum constraint removal with obstacles as the constraints: plans without some obstacles, then puts back those
// that a path does not need out.
#include "clearway/planning/explain.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <functional>
#include <set>

#include "clearway/errors.h"
#include "clearway/planning/check_path.h"
#include "core/number.h"
#include "planning/plan/trials.h"
#include "planning/space/ompl_refusal.h"

namespace clearway::planning {
namespace {

using Names = std::vector<std::string>;

/// Obstacles get this share of the time where margins are to be scaled as well.
constexpr double kShareForObstacles = 0.6;

/// Sets are no longer looked for when so many of equal size are known.
constexpr std::size_t kMostSets = 4;

/// The bisection of margins ends when it is this close, as a factor of the stated margins.
constexpr double kScaleError = 0.01;

bool contains(const Names& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

Names obstaclesOf(const Scene& scene) {
    Names names;
    for (const Obstacle& obstacle : scene.obstacles) {
        for (const Component& component : obstacle.model.components()) names.push_back(component.name);
    }
    return names;
}

/// Without names none can be left out, and without the only one there is always a path.
bool hasChoice(const Scene& scene) {
    const Names names = obstaclesOf(scene);
    return names.size() >= 2 && !contains(names, "");
}

/// Adds the obstacles among the blockers that are not yet there. The bounds are no obstacle.
void addNames(Names& names, const std::vector<Blocker>& blockers) {
    for (const Blocker& blocker : blockers) {
        if (!blocker.isBounds() && !contains(names, blocker.name)) names.push_back(blocker.name);
    }
}

/// Puts first the obstacles that stop the part next to the end where it is shut in, if it is shut in at one end only.
Names blockingOrder(const WhyNoPath& why) {
    std::vector<Blocker> blockers = why.blockers;
    const bool isStartShut = why.isShutIn(why.start), isGoalShut = why.isShutIn(why.goal);
    if (isStartShut != isGoalShut) {
        const auto count = [&](const Blocker& blocker) {
            return isStartShut ? blocker.atStart : blocker.atGoal;
        };
        std::stable_sort(blockers.begin(), blockers.end(),
                         [&](const Blocker& a, const Blocker& b) { return count(a) > count(b); });
    }
    Names names;
    addNames(names, blockers);
    return names;
}

/// The scene with named obstacles left out or alone in it. Obstacles that were asked for have a model of their own.
class ChangedScenes {
  public:
    ChangedScenes(const Problem& problem, const ExplainOptions& options, const Names& names)
        : problem_(problem), options_(options), scene_(load(names)) {}

    const Scene& whole() const { return scene_; }

    Scene without(const Names& names) {
        makeApart(names);
        return filtered([&](const std::string& name) { return !contains(names, name); });
    }

    Scene only(const std::string& name) {
        makeApart({name});
        return filtered([&](const std::string& other) { return other == name; });
    }

    Scene withMarginsScaled(double factor) const {
        Scene scene = scene_;
        for (Obstacle& obstacle : scene.obstacles) obstacle.margin *= factor;
        return scene;
    }

  private:
    Scene load(const Names& apart) {
        apart_.insert(apart.begin(), apart.end());
        problem_.rules.apart.assign(apart_.begin(), apart_.end());
        return options_.load(problem_);
    }

    void makeApart(const Names& names) {
        const bool areApart = std::all_of(names.begin(), names.end(),
                                          [&](const std::string& name) { return apart_.count(name) > 0; });
        if (!areApart) scene_ = load(names);
    }

    /// isIn: called with the name of an obstacle that is apart, and with an empty one for the others together.
    template <class IsIn>
    Scene filtered(const IsIn& isIn) const {
        Scene scene = scene_;
        scene.obstacles.clear();
        for (const Obstacle& obstacle : scene_.obstacles) {
            const std::vector<Component>& components = obstacle.model.components();
            const bool isApart = components.size() == 1 && apart_.count(components[0].name) > 0;
            if (isIn(isApart ? components[0].name : std::string())) scene.obstacles.push_back(obstacle);
        }
        scene.ignoredBox = scene_.environmentBox();
        return scene;
    }

    Problem problem_;
    const ExplainOptions& options_;
    std::set<std::string> apart_;
    Scene scene_;
};

class Search {
  public:
    Search(const Problem& problem, const WhyNoPath& why, const ExplainOptions& options)
        : order_(blockingOrder(why)),
          scenes_(problem, options, order_),
          problem_(bounded(problem, scenes_.whole())),
          isStopped_(options.plan.isStopped),
          trials_(problem_, options) {}

    Explanation run() {
        const bool hasMargins = scenes_.whole().largestMargin() > 0;
        result_.areObstaclesTried = hasChoice(scenes_.whole());
        if (hasMargins && result_.areObstaclesTried) trials_.allow(kShareForObstacles);
        if (result_.areObstaclesTried) findSets();
        result_.isOutOfTime = trials_.isOver();
        trials_.allow(1);
        if (hasMargins && result_.path.empty()) findMargin();
        result_.isOutOfTime = result_.isOutOfTime || trials_.isOver();
        result_.isStopped = isStopped_ && isStopped_();
        result_.trials = trials_.count();
        result_.trialSeconds = trials_.secondsOfEach();
        return std::move(result_);
    }

  private:
    /// The bounds must not depend on the obstacles of a trial.
    static Problem bounded(Problem problem, const Scene& scene) {
        requireExplainable(scene);
        problem.volume = boundsOf(problem, scene.environmentBox(), scene.part.box());
        return problem;
    }

    /// Any further minimal set omits an obstacle of each known set; the search keeps those obstacles in place.
    void findSets() {
        std::deque<Names> kept = {{}};
        for (; !kept.empty() && result_.withoutThese.size() < kMostSets; kept.pop_front()) {
            const auto set = setWithout(kept.front());
            if (!result_.path.empty()) return;  // nothing has to go
            if (!set) continue;
            keepIfSmall(*set);
            for (const std::string& name : *set) {
                kept.push_back(kept.front());
                kept.back().push_back(name);
            }
        }
    }

    void keepIfSmall(Names set) {
        std::vector<Names>& best = result_.withoutThese;
        std::sort(set.begin(), set.end());
        if (set.empty() || (!best.empty() && set.size() > best[0].size())) return;
        if (!best.empty() && set.size() < best[0].size()) best.clear();
        if (std::find(best.begin(), best.end(), set) == best.end()) best.push_back(set);
    }

    /// Leaves out the obstacles in their order, twice as many each time, until there is a path.
    std::optional<Names> setWithout(const Names& kept) {
        for (std::size_t count = 1; !trials_.isOver(); count *= 2) {
            Names removed;
            for (const std::string& name : order_) {
                if (removed.size() < count && !contains(kept, name)) removed.push_back(name);
            }
            if (removed.empty()) return std::nullopt;
            if (const auto set = neededAmong(removed)) return reduced(*set);
            const std::size_t known = order_.size();
            addNames(order_, trials_.blockers());
            if (removed.size() < count && order_.size() == known) return std::nullopt;
        }
        return std::nullopt;
    }

    /// Those of the removed obstacles that a path without them runs into. Nothing when no path is found.
    std::optional<Names> neededAmong(const Names& removed) {
        const auto found = trials_.run(scenes_.without(removed));
        if (!found) return std::nullopt;
        Names needed;
        for (const std::string& name : removed) {
            if (!checkPath(problem_, scenes_.only(name), found->path, {}).audit.isValid())
                needed.push_back(name);
        }
        if (needed.empty()) result_.path = found->path;
        return needed;
    }

    /// Puts obstacles back, those that stopped least first: half of them at once, then a quarter, in the end one by one.
    Names reduced(Names set) {
        for (std::size_t count = set.size() / 2; count >= 1; count /= 2) {
            for (std::size_t end = set.size(); end >= count && set.size() > count;) {
                const auto last = set.begin() + static_cast<std::ptrdiff_t>(end);
                Names fewer(set.begin(), last - static_cast<std::ptrdiff_t>(count));
                fewer.insert(fewer.end(), last, set.end());
                const auto needed = neededAmong(fewer);
                if (needed) set = *needed;
                end = std::min(end - count, set.size());
            }
        }
        return set;
    }

    /// Bisects the factor of the margins. A path that keeps more than its trial's margins raises the lower end.
    void findMargin() {
        double low = 0, high = 1;
        std::optional<TrialPath> found = trials_.run(scenes_.withMarginsScaled(low));
        result_.isMarginTried = found || !trials_.isOver();
        while (found) {
            low = std::max(low, scaleOf(low, *found));
            result_.marginScale = low;
            if (low >= 1) result_.path = found->path;
            if (low >= high) high = 1;  // an earlier trial missed this path
            found.reset();
            while (!found && high - low > kScaleError && !trials_.isOver()) {
                const double middle = 0.5 * (low + high);
                found = trials_.run(scenes_.withMarginsScaled(middle));
                if (found) low = middle;
                if (!found && !trials_.isOver()) high = middle;
            }
        }
        result_.refusedScale = high;
    }

    /// The margins, scaled, that a path keeps which was found with margins scaled by less.
    double scaleOf(double scale, const TrialPath& found) const {
        const double kept = scale + std::max(0.0, found.clearance) / scenes_.whole().largestMargin();
        return std::min(1.0, kept);
    }

    Names order_;
    ChangedScenes scenes_;
    Problem problem_;
    std::function<bool()> isStopped_;
    Trials trials_;
    Explanation result_;
};

}  // namespace

bool isExplainable(const Scene& scene) {
    return hasChoice(scene) || scene.largestMargin() > 0;
}

void requireExplainable(const Scene& scene) {
    if (isExplainable(scene)) return;
    const Names names = obstaclesOf(scene);
    throw ArgumentError(
        "the environment has " + std::to_string(names.size()) +
        (names.size() == 1 ? " obstacle" : " obstacles") +
        (contains(names, "") ? ", not all with a name," : "") +
        " and no margin, expected a margin above 0, or at least two obstacles with names: meshes of several "
        "components, or several files");
}

Explanation explain(const Problem& problem, const WhyNoPath& why, const ExplainOptions& options) try {
    if (!(options.seconds > 0)) {
        throw ArgumentError("seconds is " + shortNumber(options.seconds) + ", expected a number above 0");
    }
    return Search(problem, why, options).run();
} catch (const ompl::Exception& refusal) {
    throw OmplRefusal(refusal);
}

}  // namespace clearway::planning
