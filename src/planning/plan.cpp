#include "planning/plan.h"

#include <ompl/geometric/PathGeometric.h>

#include <atomic>
#include <chrono>
#include <future>
#include <optional>

#include "planning/mesh_names.h"
#include "planning/ompl_messages.h"
#include "planning/planning_space.h"
#include "planning/setup.h"
#include "planning/simplify.h"
#include "planning/walk.h"

namespace clearway::planning {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;
using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// When the planner has to end. Asked from several threads by some planners.
class Budget {
  public:
    explicit Budget(const PlanOptions& options) : options_(options), begin_(Clock::now()) {
        if (!options.iterations) seconds_ = options.seconds.value_or(kDefaultSeconds);
    }

    void end() { isEnded_ = true; }
    bool isStopped() const { return options_.isStopped && options_.isStopped(); }
    bool isOutOfTime() const { return isStopped() || (seconds_ && secondsSince(begin_) >= *seconds_); }
    bool spendIteration() {
        return isEnded_ || isOutOfTime() || (options_.iterations && ++asked_ > *options_.iterations);
    }

  private:
    const PlanOptions& options_;
    Clock::time_point begin_;
    std::optional<double> seconds_;
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

void describe(const Setup& setup, const Problem& problem, const og::PathGeometric& path, const Walk& walk,
              PlanReport& report) {
    for (unsigned int i = 0; i < path.getStateCount(); ++i) {
        report.path.push_back(fromOmpl(problem.space, path.getState(i)));
        if (i == 0) continue;
        const PartState &a = report.path[i - 1], &b = report.path[i];
        report.length += (b.position - a.position).norm();
        report.turned += a.rotation.angularDistance(b.rotation);
    }
    const Scene& scene = setup.truth->scene();
    report.least.state = fromOmpl(problem.space, walk.where->get());
    report.least.lower = walk.leastDistance;
    report.least.upper = walk.least.upper;
    report.least.statesChecked = walk.states;
    if (walk.least.partTriangle < 0) return;  // farther than the environment's reach tells
    report.least.partMesh = meshName(scene.part, walk.least.partComponent);
    report.least.environmentMesh = obstacleName(scene, walk.least);
}

std::optional<Walk> recheck(const Setup& setup, const og::PathGeometric& path, const Budget& budget,
                            double guard) {
    const auto isStopped = [&] { return budget.isStopped(); };
    if (setup.recheck) return walkCertified(path, *setup.recheck, isStopped);
    const int refine =
        guard > 0 ? 2 : 1;  // with a guard the states between the checked ones must pass as well
    return walk(path, *setup.truth, *setup.discrete, refine, isStopped);
}

/// Simplifies, then looks at all of it again; the planner's own path when the simplified one does not pass.
void finish(const Setup& setup, const Problem& problem, const Budget& budget, PlanReport& report) {
    ob::PlannerSolution solution(nullptr);
    setup.definition->getSolution(solution);
    report.foundBy = solution.plannerName_;
    auto& raw = *setup.definition->getSolutionPath()->as<og::PathGeometric>();
    report.statesBefore = raw.getStateCount();
    og::PathGeometric path = raw;
    simplify(setup.si, path, [&] { return budget.isOutOfTime(); });
    auto walked = recheck(setup, path, budget, report.guard);
    if (!walked && !budget.isStopped()) {
        report.warnings.push_back(
            "the simplified path did not pass its re-check; the planner's own path is used");
        path = raw;
        walked = recheck(setup, path, budget, report.guard);
    }
    if (budget.isStopped()) {
        report.outcome = PlanReport::Outcome::kStopped;
    } else if (!walked) {
        report.warnings.push_back("the planner's path did not pass its re-check; it counts as none");
    } else {
        describe(setup, problem, path, *walked, report);
        report.outcome = PlanReport::Outcome::kFound;
    }
}

std::uint64_t checksOf(const Setup& setup) {
    std::uint64_t checks = setup.truth->counters().checks;
    if (setup.checker != setup.truth) checks += setup.checker->counters().checks;
    if (setup.certified) checks += setup.certified->counters().queries;
    return checks;
}

}  // namespace

PlanReport plan(const Problem& problem, const Scene& scene, const PlanOptions& options) {
    PlanReport report;
    const OmplMessages messages;
    const Setup setup = prepare(problem, scene, options, report);
    report.isCertified = setup.certified != nullptr;

    const Clock::time_point begin = Clock::now();
    Budget budget(options);
    solve(setup, budget);
    report.planningSeconds = secondsSince(begin);

    const Clock::time_point planned = Clock::now();
    if (budget.isStopped()) {
        report.outcome = PlanReport::Outcome::kStopped;
    } else if (setup.definition->hasExactSolution()) {
        finish(setup, problem, budget, report);
    }
    report.finishingSeconds = secondsSince(planned);
    report.checks = checksOf(setup) + report.least.statesChecked * report.isCertified;
    for (const std::string& warning : messages.warnings()) report.warnings.push_back("OMPL: " + warning);
    return report;
}

}  // namespace clearway::planning
