#include "clearway/planning/plan.h"

#include <ompl/geometric/PathGeometric.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>
#include <utility>

#include "clearway/planning/ompl_messages.h"
#include "clearway/planning/planners.h"
#include "core/clock.h"
#include "core/watch.h"
#include "planning/plan/finish.h"
#include "planning/plan/plan_setup.h"
#include "planning/plan/problem_settings.h"
#include "planning/plan/widening.h"
#include "planning/space/ompl_refusal.h"
#include "planning/space/ompl_states.h"

namespace clearway::planning {
namespace {

/// The share of the time that planners get that would use all of it. The rest is for shortening.
constexpr double kImprovingShare = 0.75;

/// Slack of a range's positions, as a share of the bounds' diagonal: OMPL accepts a state that is outside the
/// bounds by rounding.
constexpr double kBoundsSlack = 1e-9;

/// Seconds that shortening gets at least; it gets as many as the planning took where that is more. In a scene
/// with hardly any clearance shortening could go on without end.
constexpr double kLeastFinishing = 5;

/// Shortening ends with an audit and a check of the clearance, which do not look at the time. A widened path has more states: both take as
/// long as so many audits of the path that planners found.
constexpr double kAuditsAtEnd = 6;

/// Seconds that widening gets: as many as planning took, within these, and within half of the time left. It gets up to
/// kGrowing times as many, within kMostWideningSeconds, while the clearance still grows fast,
/// and a quarter more before a second way was widened.
constexpr double kLeastWideningSeconds = 1, kMostWideningSeconds = 5, kGrowing = 3;
constexpr double kWideningShare = 0.5;
/// With iterations a sweep of a band counts as so many of them. A sweep and as many iterations of RRTConnect take about
/// the same time, and the most and the least sweeps about the seconds above.
constexpr std::uint64_t kIterationsPerSweep = 100, kLeastSweeps = 64, kMostSweeps = 320;
/// Seconds for trying what stops the part, where no path was found. It ends as many seconds after the limit.
constexpr double kMostAsking = 1;
/// Seconds for reading the planners' trees, for each valid motion: two or three of these make a state of a tree. Planners
/// end so early that all is read half of kMostAsking after the limit.
constexpr double kReadingMotion = 6e-6;
/// The same for each time that planners ask whether to end: lazy ones have states in their trees without valid motions.
constexpr double kReadingAsked = 5e-6;

/// Decides when the planner has to end. Some planners ask from several threads.
class Budget {
  public:
    explicit Budget(const PlanOptions& options)
        : options_(options),
          limit_(options.iterations ? std::nullopt
                                    : std::optional(options.seconds.value_or(kDefaultSeconds))),
          seconds_(limit_) {}

    /// motions: the planners' validator, which counts their motions.
    void beginPlanning(bool isImproving, const MotionValidator& motions) {
        motions_ = &motions;
        if (limit_) planningSeconds_ = (isImproving ? kImprovingShare : 1) * *limit_;
    }

    /// Leaves all of the time to planners that spent their share of it. Returns whether there is any.
    bool allowAll() {
        if (!planningSeconds_ || !isOver(planningSeconds_) || isDue()) return false;
        planningSeconds_ = limit_;
        return true;
    }

    bool isTimed() const { return seconds_.has_value(); }

    /// Leaves so many seconds at the end for work that does not look at the time.
    void reserve(double seconds) {
        if (seconds_) *seconds_ -= seconds;
    }

    void beginWidening() {
        if (!seconds_) return;
        const double planned = secondsSince(begin_);
        const double left = std::max(0.0, *seconds_ - planned);
        const double seconds = std::clamp(planned, kLeastWideningSeconds, kMostWideningSeconds);
        wideningDueSeconds_ = planned + std::min(kWideningShare * left, seconds);
        wideningSeconds_ =
            planned + std::min(kWideningShare * left, std::min(kGrowing * seconds, kMostWideningSeconds));
    }

    std::optional<std::uint64_t> wideningSweeps() const {
        if (!options_.iterations) return std::nullopt;
        const std::uint64_t spent = std::min<std::uint64_t>(asked_, *options_.iterations);
        return std::clamp(spent / kIterationsPerSweep, kLeastSweeps, kMostSweeps);
    }

    void beginFinishing() {
        if (!seconds_) return;
        const double planned = secondsSince(begin_);
        seconds_ = std::min(*seconds_, planned + std::max(kLeastFinishing, planned));
    }

    void end() { isEnded_ = true; }
    /// Whether all has to end, whatever the phase. Any thread may ask.
    bool isDue() const { return isStopped() || isOver(limit_); }
    /// Whether looking for the reason why there is no path has to end.
    bool isAskingOver() const {
        return isStopped() || (limit_ && secondsSince(begin_) >= *limit_ + kMostAsking);
    }
    bool isPlanningOver() const {
        return isEnded_ || isStopped() || isOver(planningSeconds_) || isReadingDue();
    }
    bool isStopped() const { return options_.isStopped && options_.isStopped(); }
    bool isWideningDue() const { return isOver(wideningDueSeconds_); }
    bool isWideningOver() const { return isStopped() || isOver(wideningSeconds_); }
    bool isOutOfTime() const { return isStopped() || isOver(seconds_); }
    bool spendIteration() {
        if (isPlanningOver()) return true;
        const std::uint64_t asked = ++asked_;
        return options_.iterations && asked > *options_.iterations;
    }

  private:
    /// Whether reading the trees would take too long from now on. Planners that improve a path have less time anyway, and no trees
    /// to be read.
    bool isReadingDue() const {
        if (!limit_ || motions_ == nullptr || planningSeconds_ < limit_) return false;
        const double reading = std::max(kReadingMotion * static_cast<double>(motions_->counters().valid),
                                        kReadingAsked * static_cast<double>(asked_));
        return secondsSince(begin_) + reading >= *limit_ + 0.5 * kMostAsking;
    }

    bool isOver(const std::optional<double>& seconds) const {
        return seconds && secondsSince(begin_) >= *seconds;
    }

    const PlanOptions& options_;
    const Clock::time_point begin_ = Clock::now();
    const std::optional<double> limit_;
    const MotionValidator* motions_ = nullptr;
    std::optional<double> seconds_, planningSeconds_, wideningDueSeconds_, wideningSeconds_;
    std::atomic<std::uint64_t> asked_{0};
    std::atomic<bool> isEnded_{false};
};

void describe(const Problem& problem, const og::PathGeometric& path, PlanReport& report) {
    for (unsigned int i = 0; i < path.getStateCount(); ++i) {
        report.path.push_back(fromOmpl(problem.space, path.getState(i)));
    }
    report.length = report.audit.length;
    report.rotation = report.audit.rotation;
}

void tellPhase(PlanPhase phase, const PlanOptions& options) {
    if (options.onPhase) options.onPhase(phase);
}

bool wantsWidening(const PlanOptions& options, const PlanReport& report) {
    return report.objective.empty() && !options.quick;
}

/// Widens the path. Returns the clearance that its motions keep; 0 when it was not widened.
double widen(const PlanSetup& setup, Budget& budget, og::PathGeometric& path, PlanReport& report) {
    const Clock::time_point begin = Clock::now();
    budget.beginWidening();
    WideningLimits limits;
    limits.sweeps = budget.wideningSweeps();
    limits.planningSeconds = report.planningSeconds;
    limits.range = report.range;
    limits.threads = report.threads;
    limits.isDue = [&] { return budget.isWideningDue(); };
    limits.isSpent = [&] { return budget.isWideningOver(); };
    report.widening = widenPath(setup, path, limits);
    report.widening->seconds = secondsSince(begin);
    return report.widening->after;
}

/// Takes the audited path into the report, unless it is not valid.
void take(const PlanSetup& setup, const Problem& problem, const og::PathGeometric& path, PlanReport& report) {
    if (!report.audit.isValid()) {
        report.warnings.push_back("the planner's path did not pass its audit; it counts as none");
        return;
    }
    describe(problem, path, report);
    const ob::OptimizationObjectivePtr& objective = setup.definition->getOptimizationObjective();
    if (objective) report.cost = path.cost(objective).value();
    report.outcome = PlanReport::Outcome::kFound;
}

/// Leaves time for the audits of the path in the end. Returns false when there is no time for one.
bool reserveForAudits(const PlanSetup& setup, const og::PathGeometric& path, Budget& budget) {
    if (!budget.isTimed()) return true;
    const Clock::time_point begin = Clock::now();
    try {
        audit(path, *setup.auditor, {false, [&] { return budget.isOutOfTime(); }});
    } catch (const AuditStopped&) {
        return false;
    }
    budget.reserve(kAuditsAtEnd * secondsSince(begin));
    return true;
}

void describeSolution(const PlanSetup& setup, const Problem& problem, const PlanOptions& options,
                      Budget& budget, PlanReport& report) {
    const ob::PlannerSolution solution = solutionOf(setup);
    report.foundBy = solution.plannerName_;
    og::PathGeometric path = pathOf(setup, solution);
    report.statesBefore = path.getStateCount();
    const bool isWideningWanted =
        wantsWidening(options, report) && path.getStateCount() > 1 && reserveForAudits(setup, path, budget);
    if (isWideningWanted) tellPhase(PlanPhase::kWidening, options);
    const double kept = isWideningWanted ? widen(setup, budget, path, report) : 0;
    tellPhase(PlanPhase::kFinishing, options);
    budget.beginFinishing();
    report.audit = finish(
        setup, path, [&] { return budget.isOutOfTime(); }, kept);
    if (cutOutside(setup, path)) report.audit = audit(path, *setup.auditor);
    if (report.widening &&
        report.audit.isValid())  // after an interrupt nobody made sure that shortening kept it
        report.widening->after = std::min(report.widening->after, report.audit.upperClearance);
    if (std::isinf(report.audit.lowerClearance))
        report.widening.reset();  // there is nothing to keep clear of
    take(setup, problem, path, report);
}

/// When the planners' trees turn out to be a path together, adds it to the solutions and returns true. Otherwise tells
/// why there is no path.
bool joinOrTellWhy(const PlanSetup& setup, const Problem& problem, const PlanOptions& options,
                   const Budget& budget, PlanReport& report) {
    tellPhase(PlanPhase::kAskingWhy, options);
    WhyNoPathOptions asking;
    if (!options.iterations) asking.seconds = kMostAsking;
    asking.seed = options.seed;
    asking.isStopped = [&] { return budget.isAskingOver(); };
    const OmplMessages unobserved;  // some planners log that they tell only a part of their states
    WhyNoPath why = whyNoPath({setup.planners, setup.definition, setup.auditor}, problem, asking);
    if (why.isJoined) {
        const auto path = std::make_shared<og::PathGeometric>(setup.si);
        for (const PartState& state : why.nearest.path) {
            path->append(toOmpl(setup.si->getStateSpace(), problem.space, state).get());
        }
        ob::PlannerSolution solution(path);
        solution.setPlannerName("the trees of several planners, joined");
        setup.definition->addSolutionPath(solution);
        return true;
    }
    report.whyNoPath = std::move(why);
    return false;
}

std::uint64_t checksOf(const PlanSetup& setup) {
    return setup.checker->counters().checks + setup.certified->counters().queries +
           setup.auditor->counters().queries;
}

/// Fills in how planning ended, in all.
void conclude(const PlanSetup& setup, const Budget& budget, const OmplMessages& messages,
              PlanReport& report) {
    report.isStopped = budget.isStopped();
    if (report.isStopped && report.outcome == PlanReport::Outcome::kNotFound) {
        report.outcome = PlanReport::Outcome::kStopped;
    }
    report.checks = checksOf(setup) + report.audit.queries;
    for (const std::string& warning : messages.warnings()) report.warnings.push_back("OMPL: " + warning);
}

/// Takes the planners' best path so far into the report, if there is one. Returns false when isEnded() during the audit.
bool takeBest(const PlanSetup& setup, const Problem& problem, const std::function<bool()>& isEnded,
              PlanReport& report) {
    if (!setup.definition->hasExactSolution()) return true;
    const ob::PlannerSolution solution = solutionOf(setup);
    const og::PathGeometric path = pathOf(setup, solution);
    report.foundBy = solution.plannerName_;
    report.statesBefore = path.getStateCount();
    try {
        report.audit = audit(path, *setup.auditor, {false, isEnded});
    } catch (const AuditStopped&) {
        return false;
    }
    take(setup, problem, path, report);
    return true;
}

}  // namespace

PlanReport plan(const Problem& problem, const Scene& scene, const PlanOptions& options) try {
    PlanReport report;
    const OmplMessages messages;
    Budget budget(options);
    const PlanSetup setup =
        makePlanSetup(problem, scene, options, report, [&] { return budget.isPlanningOver(); });
    std::optional<Pose> goal;
    if (!problem.outside) goal = poseOf(problem.goal);
    report.shutIn = provedShutIn(scene, poseOf(problem.start), goal);
    if (report.shutIn) return report;

    const Clock::time_point begin = Clock::now();
    budget.beginPlanning(!report.objective.empty(), *setup.certified);
    std::optional<Watch> watch;
    std::atomic<double> planningSeconds{0};  // 0 while planners are at work
    if (options.onOverrun) {
        const auto tell = [&, begun = report](const Watch::IsEnded& isEnded) {
            PlanReport soFar = begun;
            const double seconds = secondsSince(begin), planned = planningSeconds;
            soFar.planningSeconds = planned > 0 ? planned : seconds;
            if (planned > 0) soFar.finishingSeconds = seconds - planned;
            if (!takeBest(setup, problem, isEnded, soFar)) return;
            conclude(setup, budget, messages, soFar);
            options.onOverrun(soFar);
        };
        watch.emplace([&] { return budget.isDue(); }, kMostOverrun, tell);
    }
    tellPhase(PlanPhase::kPlanning, options);
    const ob::PlannerTerminationCondition isSpent([&] { return budget.spendIteration(); });
    const auto solve = [&] { solveSideBySide(setup.planners, isSpent, [&] { budget.end(); }); };
    solve();
    // Without a path there is nothing to shorten.
    if (!setup.definition->hasExactSolution() && budget.allowAll()) solve();
    planningSeconds = report.planningSeconds = secondsSince(begin);

    const Clock::time_point planned = Clock::now();
    const bool isFound = setup.definition->hasExactSolution() ||
                         (!budget.isStopped() && joinOrTellWhy(setup, problem, options, budget, report));
    if (isFound) describeSolution(setup, problem, options, budget, report);
    watch.reset();
    report.finishingSeconds = secondsSince(planned);
    conclude(setup, budget, messages, report);
    return report;
} catch (const ompl::Exception& refusal) {
    throw OmplRefusal(refusal);
}

std::optional<QueryRange> planningRange(const Problem& problem, const PlanOptions& options, const Model& part,
                                        const Box& environmentBox) {
    if (mayUseSampler(problem, "max_clearance")) return std::nullopt;
    const Box bounds = boundsOf(problem, environmentBox, part.box());
    const Vector3 slack = Vector3::Constant(kBoundsSlack * bounds.diagonal().norm());
    const double radius = part.radiusAboutOrigin();
    const auto objective = chooseObjective(problem, options);
    const double clearance = objective ? largestClearance(*objective, part) : 0;
    if (std::isinf(clearance)) return std::nullopt;
    const double largestNeeded = std::max(finenessOf(problem, part), clearance);
    const double cap = largestMargin(problem) + largestNeeded + 2 * radius;
    return QueryRange{Box(bounds.min() - slack, bounds.max() + slack), radius, cap};
}

}  // namespace clearway::planning
