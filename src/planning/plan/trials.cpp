#include "planning/plan/trials.h"

#include <algorithm>
#include <atomic>

#include "clearway/planning/ompl_messages.h"
#include "clearway/planning/planners.h"
#include "clearway/planning/problem_setup.h"
#include "planning/plan/finish.h"
#include "planning/plan/plan_setup.h"

namespace clearway::planning {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

/// A trial without iterations takes this share of the whole time when it finds no path, but at least kLeastSeconds.
constexpr double kShareOfTrial = 1.0 / 16;
constexpr double kLeastSeconds = 0.3;

/// Motions tried after a trial that found no path: enough to name the next obstacle.
constexpr std::size_t kMotions = 200;

/// Share of a trial's time that is spent on trying motions.
constexpr double kShareOfMotions = 0.25;

/// Without an objective a trial ends with its first path.
Problem withoutObjective(Problem problem) {
    problem.planning.objective = "length";
    problem.planning.objectiveThreshold.reset();
    return problem;
}

PlanOptions trialOptions(const ExplainOptions& options) {
    PlanOptions trial = options.plan;
    trial.onOverrun = nullptr;  // a trial's path is not that of the problem
    if (!trial.objective.empty())
        trial.planner.clear();  // it may be a planner that never ends with a first path
    trial.objective.clear();
    trial.wantedClearance.reset();
    trial.floor.reset();
    trial.seconds.reset();
    if (!trial.iterations) trial.seconds = std::max(kLeastSeconds, kShareOfTrial * options.seconds);
    return trial;
}

}  // namespace

Trials::Trials(const Problem& problem, const ExplainOptions& options)
    : problem_(withoutObjective(problem)),
      options_(trialOptions(options)),
      seconds_(options.seconds),
      begin_(Clock::now()) {
    const auto isStopped = options.plan.isStopped;
    options_.isStopped = [this, isStopped] {
        return (isStopped && isStopped()) || secondsSince(begin_) >= share_ * seconds_;
    };
}

std::optional<TrialPath> Trials::run(const Scene& scene) {
    if (isOver()) return std::nullopt;
    ++count_;
    const OmplMessages unobserved;
    const Clock::time_point begin = Clock::now();
    std::atomic<std::uint64_t> asked{0};
    std::atomic<bool> isFound{false};
    const auto isSpent = [&] {
        return isFound || isOver() || (options_.seconds && secondsSince(begin) >= *options_.seconds);
    };
    PlanReport report;
    const PlanSetup setup = makePlanSetup(problem_, scene, options_, report, isSpent);
    const ob::PlannerTerminationCondition spendIteration(
        [&] { return isSpent() || (options_.iterations && ++asked > *options_.iterations); });
    solveSideBySide(setup.planners, spendIteration, [&] { isFound = true; });
    return foundBy(setup);
}

std::optional<TrialPath> Trials::foundBy(const PlanSetup& setup) {
    TrialPath found;
    if (setup.definition->hasExactSolution()) {
        found.path = partStates(pathOf(setup, solutionOf(setup)));
    } else if (!isOver()) {
        WhyNoPathOptions asking{kMotions, {}, options_.seed, options_.isStopped};
        if (!options_.iterations) asking.seconds = kShareOfMotions * *options_.seconds;
        WhyNoPath why = whyNoPath({setup.planners, setup.definition, setup.auditor}, problem_, asking);
        blockers_ = std::move(why.blockers);
        if (why.isJoined) found.path = std::move(why.nearest.path);
    }
    if (found.path.empty()) return std::nullopt;
    const PathAudit audited = audit(pathThrough(setup.si, found.path), *setup.auditor);
    if (!audited.isValid()) return std::nullopt;
    found.clearance = audited.lowerClearance;
    return found;
}

}  // namespace clearway::planning
