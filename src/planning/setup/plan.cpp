#include "planning/setup/plan.h"

#include <ompl/geometric/PathGeometric.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <future>
#include <optional>
#include <sstream>

#include "planning/setup/finish.h"
#include "planning/setup/planning_space.h"
#include "planning/setup/setup.h"
#include "planning/validity/ompl_messages.h"

namespace clearway::planning {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;
using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// Of the time, for planners that would use all of it: the rest is for shortening.
constexpr double kImprovingShare = 0.75;

/// Seconds for shortening, or as many as the planning took: where there is hardly room it could go on for
/// ever.
constexpr double kLeastFinishing = 5;

/// When the planner has to end. Asked from several threads by some planners.
class Budget {
  public:
    explicit Budget(const PlanOptions& options) : options_(options) {}

    void begin(bool isImproving) {
        begin_ = Clock::now();
        if (options_.iterations) return;
        seconds_ = options_.seconds.value_or(kDefaultSeconds);
        planningSeconds_ = (isImproving ? kImprovingShare : 1) * *seconds_;
    }

    void beginFinishing() {
        if (!seconds_) return;
        const double planned = secondsSince(begin_);
        seconds_ = std::min(*seconds_, planned + std::max(kLeastFinishing, planned));
    }

    void end() { isEnded_ = true; }
    bool isPlanningOver() const { return isEnded_ || isStopped() || isOver(planningSeconds_); }
    bool isStopped() const { return options_.isStopped && options_.isStopped(); }
    bool isOutOfTime() const { return isStopped() || isOver(seconds_); }
    bool spendIteration() {
        return isPlanningOver() || (options_.iterations && ++asked_ > *options_.iterations);
    }

  private:
    bool isOver(const std::optional<double>& seconds) const {
        return seconds && secondsSince(begin_) >= *seconds;
    }

    const PlanOptions& options_;
    Clock::time_point begin_;
    std::optional<double> seconds_, planningSeconds_;
    std::atomic<std::uint64_t> asked_{0};
    std::atomic<bool> isEnded_{false};
};

/// The first planner with a path ends them all.
void solve(const Setup& setup, Budget& budget) {
    const ob::PlannerTerminationCondition isSpent([&] { return budget.spendIteration(); });
    std::vector<std::future<void>> others;
    const auto solveOne = [&](const ob::PlannerPtr& planner) {
        if (planner->solve(isSpent) == ob::PlannerStatus::EXACT_SOLUTION) budget.end();
    };
    for (std::size_t i = 1; i < setup.planners.size(); ++i) {
        others.push_back(std::async(std::launch::async, solveOne, setup.planners[i]));
    }
    solveOne(setup.planners[0]);
    for (std::future<void>& other : others) other.get();
}

void describe(const Problem& problem, const og::PathGeometric& path, PlanReport& report) {
    for (unsigned int i = 0; i < path.getStateCount(); ++i) {
        report.path.push_back(fromOmpl(problem.space, path.getState(i)));
    }
    report.length = report.audit.length;
    report.turned = report.audit.turned;
}

/// Where a path that was checked in steps is not certified.
std::string doubtOf(const PathAudit& audit) {
    std::ostringstream text;
    const std::size_t first = audit.notValid.at(0);
    const SegmentAudit& segment = audit.segments[first];
    text << "motions were checked in steps, and the path is not valid along its whole length: segment "
         << first + 1 << " of " << audit.segments.size()
         << ", valid up to t = " << segment.motion.certifiedTime << ", is " << segment.trouble;
    return text.str();
}

void describeSolution(const Setup& setup, const Problem& problem, const Budget& budget, PlanReport& report) {
    const ob::PlannerSolution solution = solutionOf(setup);
    report.foundBy = solution.plannerName_;
    og::PathGeometric path = pathOf(setup, solution);
    report.statesBefore = path.getStateCount();
    report.audit = finish(setup, path, [&] { return budget.isOutOfTime(); });
    if (budget.isStopped()) {
        report.outcome = PlanReport::Outcome::kStopped;
    } else if (report.isCertified && !report.audit.isValid()) {
        report.warnings.push_back("the planner's path did not pass its audit; it counts as none");
    } else {
        if (!report.audit.isValid()) report.warnings.push_back(doubtOf(report.audit));
        describe(problem, path, report);
        const ob::OptimizationObjectivePtr& objective = setup.definition->getOptimizationObjective();
        if (objective) report.cost = path.cost(objective).value();
        report.outcome = PlanReport::Outcome::kFound;
    }
}

std::uint64_t checksOf(const Setup& setup) {
    std::uint64_t checks = setup.truth->counters().checks;
    if (setup.checker != setup.truth) checks += setup.checker->counters().checks;
    if (setup.certified) checks += setup.certified->counters().queries;
    return checks + setup.auditor->counters().queries;
}

}  // namespace

PlanReport plan(const Problem& problem, const Scene& scene, const PlanOptions& options) {
    PlanReport report;
    const OmplMessages messages;
    Budget budget(options);
    const Setup setup = prepare(problem, scene, options, report, [&] { return budget.isPlanningOver(); });
    report.isCertified = setup.certified != nullptr;

    const Clock::time_point begin = Clock::now();
    budget.begin(!report.objective.empty());
    solve(setup, budget);
    report.planningSeconds = secondsSince(begin);

    const Clock::time_point planned = Clock::now();
    budget.beginFinishing();
    if (budget.isStopped()) {
        report.outcome = PlanReport::Outcome::kStopped;
    } else if (setup.definition->hasExactSolution()) {
        describeSolution(setup, problem, budget, report);
    }
    report.finishingSeconds = secondsSince(planned);
    report.checks = checksOf(setup) + report.audit.queries;
    for (const std::string& warning : messages.warnings()) report.warnings.push_back("OMPL: " + warning);
    return report;
}

}  // namespace clearway::planning
