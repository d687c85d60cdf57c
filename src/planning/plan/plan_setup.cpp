#include "planning/plan/plan_setup.h"

#include <ompl/geometric/planners/AnytimePathShortening.h>
#include <ompl/util/RandomNumbers.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <thread>

#include "clearway/errors.h"
#include "clearway/planning/ompl_messages.h"
#include "clearway/planning/planners.h"
#include "core/number.h"
#include "core/text.h"
#include "planning/check/motion_resolution.h"
#include "planning/plan/goals.h"
#include "planning/plan/problem_settings.h"
#include "planning/space/ompl_states.h"

namespace clearway::planning {
namespace {

constexpr const char* kDefaultPlanner = "PlannerTeam";
/// The planners that AnytimePathShortening runs side by side, and with them the default planner, which finds ways where OMPL's
/// own do not.
constexpr const char* kShortenedPlanners[] = {"RRTConnect", "RRT"};
/// With an objective the defaults are anytime planners that find paths through tight places, where RRTstar and PRMstar find
/// none in their time (bench/anytime_clearance). With iterations the default is RRTstar, because it is repeatable.
constexpr const char* kLeastClearancePlanner = "RisingFloor";
constexpr const char* kImprovingPlanner = "AnytimePathShortening";
constexpr const char* kRepeatableImprovingPlanner = "RRTstar";
constexpr std::size_t kMostThreads = 4;  ///< unless more are asked for
/// The longest edge of a planner's tree: so many times the problem's fineness where that is stated, else a share of the
/// part's diagonal. Measured on the tunnel-console (tests/bench/plan_success.cpp) and on OMPL.app's problems.
constexpr double kRangePerFineness = 20;
constexpr double kRangePerDiagonal = 0.25;
/// Shortened paths keep this share of the part's diagonal as clearance where they can. On
/// tunnel-console-small paths get no longer by it; a floor of ten times as much costs 2 %.
constexpr double kFloorPerDiagonal = 1e-3;

void requireOptions(const Problem& problem, const PlanOptions& options) {
    if (options.floor && !(*options.floor >= 0 && std::isfinite(*options.floor))) {
        throw RefusedOption("floor is " + shortNumber(*options.floor) + ", expected a finite number >= 0");
    }
    if (options.quick && !options.objective.empty()) {
        throw RefusedOption("both quick and an objective are given, expected one of them");
    }
    const auto objective = chooseObjective(problem, options);
    if (options.wantedClearance && !(objective && objective->name == kLengthWithClearance)) {
        throw RefusedOption("a wanted clearance is given " +
                            (objective ? "with the objective " + objective->name : "without an objective") +
                            ", expected the objective " + kLengthWithClearance);
    }
    if (options.seed == 0) throw RefusedOption("seed is 0, expected a whole number above 0");
    if (options.seconds && options.iterations) {
        throw RefusedOption("both a time and a number of iterations are given, expected one of them");
    }
    if (options.seconds && !(*options.seconds > 0 && std::isfinite(*options.seconds))) {
        throw RefusedOption("time is " + std::to_string(*options.seconds) +
                            ", expected a finite number of seconds above 0");
    }
    if (options.threads < 0 || (options.iterations && options.threads > 1)) {
        throw RefusedOption("threads is " + std::to_string(options.threads) +
                            (options.iterations ? ", expected 1 with a number of iterations"
                                                : ", expected a whole number of at least 0"));
    }
    for (const PlannerChoice& choice : problem.planning.planners) {
        try {
            plannerClassName(choice.name);
        } catch (const std::invalid_argument& error) {
            throw ArgumentError(problem.file + ": " + error.what());
        }
    }
}

/// OMPL warns about a second call in a process, because objects made before it go on with their old seeds.
/// Ours are made after it, so that the warning is dropped.
void setSeed(std::uint32_t seed) {
    const OmplMessages unobserved;
    ompl::RNG::setSeed(seed);
}

/// How many planners run side by side. With iterations the clock must not decide who is next.
std::size_t planCount(const PlanOptions& options) {
    if (options.iterations) return 1;
    if (options.threads > 0) return static_cast<std::size_t>(options.threads);
    return std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, kMostThreads);
}

/// The planner unless one is named.
const char* defaultPlanner(const std::optional<ObjectiveChoice>& objective, const PlanOptions& options) {
    if (!objective) return kDefaultPlanner;
    if (options.iterations) return kRepeatableImprovingPlanner;
    return objective->name == kLeastClearance ? kLeastClearancePlanner : kImprovingPlanner;
}

/// The planners to run side by side.
std::vector<std::string> choosePlanners(const Problem& problem, const PlanOptions& options,
                                        const std::optional<ObjectiveChoice>& objective) {
    std::string name = defaultPlanner(objective, options);
    if (!options.planner.empty()) {
        name = plannerClassName(options.planner);
    } else if (problem.planning.planners.size() == 1) {
        name = plannerClassName(problem.planning.planners[0].name);
    }
    const bool hasThreads = name == kDefaultPlanner || !isRepeatable(name);
    return std::vector<std::string>(hasThreads ? 1 : planCount(options), name);
}

/// Adds the warnings that the problem does not hold already.
void warnOfNames(const Problem& problem, std::vector<std::string>& warnings) {
    const std::vector<std::string>& told = problem.warnings;
    for (const std::string& warning : unknownNames(problem)) {
        if (std::find(told.begin(), told.end(), warning) == told.end()) warnings.push_back(warning);
    }
}

/// Leaves out unknown parameters, of which unknownNames() warns.
void setFileParameters(ob::Planner& planner, const std::string& plannerName, const Problem& problem) {
    for (const PlannerChoice& choice : problem.planning.planners) {
        if (plannerClassName(choice.name) != plannerName) continue;
        for (const auto& [name, value] : choice.parameters) {
            if (name == "name") {
                planner.setName(value);
            } else if (hasParameter(planner, name)) {
                setParameter(planner, name, value);
            }
        }
        return;  // a planner named several times is several runs of a benchmark; the first counts
    }
}

void setLengths(PlanReport& report, const Problem& problem, const Scene& scene, const PlanOptions& options) {
    const double diagonal = scene.part.box().diagonal().norm();
    report.range = problem.fineness ? kRangePerFineness * *problem.fineness : kRangePerDiagonal * diagonal;
    report.floor = options.floor.value_or(kFloorPerDiagonal * diagonal);
}

void useCertified(PlanSetup& setup, double clearance, const std::function<bool()>& isOver,
                  PlanReport& report) {
    const Scene& scene = setup.checker->scene();
    MotionOptions motions = planningMotions(scene, clearance);
    motions.isStopped = isOver;
    if (clearance < *motions.leastInterval) {
        report.warnings.push_back("start or goal have only " +
                                  withUnit(roundedNumber(clearance), scene.unit) +
                                  " to spare: motions next to them may be too close to be certified");
    }
    setup.certified = std::make_shared<MotionValidator>(setup.si, setup.checker->shared(), motions);
    setup.si->setMotionValidator(setup.certified);
}

ob::ProblemDefinitionPtr defineProblem(const PlanSetup& setup, const Problem& problem, const Scene& scene,
                                       std::vector<std::string>& warnings) {
    const auto definition = std::make_shared<ob::ProblemDefinition>(setup.si);
    const auto start = toOmpl(setup.si->getStateSpace(), problem.space, problem.start);
    definition->addStartState(start);
    definition->setGoal(makeGoal(setup.si, problem, scene));
    if (isOutside(definition->getGoal(), start.get())) {
        warnings.push_back("the start is outside already, so the path ends there");
    }
    return definition;
}

/// The planners that AnytimePathShortening runs.
std::string innerPlanners(const PlanOptions& options, const PlanReport& report) {
    constexpr std::size_t kKinds = std::size(kShortenedPlanners);
    const std::size_t count = std::max(kKinds, planCount(options));
    std::string all;
    for (std::size_t i = 0; i < count; ++i) {
        all += std::string(i > 0 ? "," : "") + kShortenedPlanners[i % kKinds] +
               "[range=" + formatNumber(report.range) + "]";
    }
    return all;
}

void setGivenParameters(ob::Planner& planner, const PlanOptions& options) {
    for (const auto& [parameter, value] : options.parameters) {
        try {
            setParameter(planner, parameter, value);
        } catch (const std::invalid_argument& error) {
            throw RefusedOption(error.what());
        }
    }
}

/// Whether the planner runs in threads of its own, whose order is the machine's.
bool hasSeveralThreads(ob::Planner& planner) {
    return hasParameter(planner, "threads") && planner.params()["threads"].getValue() != "1";
}

/// The default planner as one that AnytimePathShortening runs again and again, beside its own.
void addDefaultPlanner(og::AnytimePathShortening& shortening, const PlanReport& report) {
    ob::PlannerPtr planner = makePlanner(shortening.getSpaceInformation(), kDefaultPlanner);
    setParameter(*planner, "range", formatNumber(report.range));
    setParameter(*planner, "threads", "1");
    shortening.addPlanner(planner);
}

ob::PlannerPtr setUpPlanner(const PlanSetup& setup, const std::string& name, const Problem& problem,
                            const PlanOptions& options, PlanReport& report) {
    const ob::PlannerPtr planner = makePlanner(setup.si, name);
    if (hasParameter(*planner, "range")) setParameter(*planner, "range", formatNumber(report.range));
    if (hasParameter(*planner, "planners"))
        setParameter(*planner, "planners", innerPlanners(options, report));
    if (auto* shortening = dynamic_cast<og::AnytimePathShortening*>(planner.get()))
        addDefaultPlanner(*shortening, report);
    if (hasParameter(*planner, "threads")) setParameter(*planner, "threads", std::to_string(report.threads));
    setFileParameters(*planner, name, problem);
    setGivenParameters(*planner, options);
    planner->setProblemDefinition(setup.definition);
    planner->setup();
    return planner;
}

}  // namespace

PlanSetup makePlanSetup(const Problem& stated, const Scene& scene, const PlanOptions& options,
                        PlanReport& report, const std::function<bool()>& isOver,
                        const std::function<void(PlanSetup&)>& beforePlanners) {
    requireOptions(stated, options);
    warnOfNames(stated, report.warnings);
    const std::optional<ObjectiveChoice> objective = chooseObjective(stated, options);
    report.planners = choosePlanners(stated, options, objective);
    const Problem problem = problemFor(report.planners[0], stated);
    report.threads = static_cast<unsigned int>(planCount(options));
    report.isRepeatable = options.iterations && isRepeatable(report.planners[0]);
    if (objective) report.objective = objective->name;
    setLengths(report, problem, scene, options);
    setSeed(options.seed);

    PlanSetup setup;
    const double turnWeight = options.omplWeights ? 1.0 : scene.part.radiusAboutOrigin();
    const Box bounds = boundsOf(problem, scene.environmentBox(), scene.part.box());
    requireRangeOf(scene, bounds, finenessOf(problem, scene.part));
    setup.si = std::make_shared<ob::SpaceInformation>(makeSpace(problem.space, bounds, turnWeight));
    setup.checker = std::make_shared<ValidityChecker>(setup.si, scene);
    const auto clearanceAt = [&](const PartState& state, ProblemEnd end) {
        const auto omplState = toOmpl(setup.si->getStateSpace(), problem.space, state);
        return requireValid(problem, *setup.checker, omplState.get(), end);
    };
    const double startClearance =
        clearanceAt(problem.start, ProblemEnd::kStart);  // the start is refused before the goal
    const double leastAtEnds = problem.outside
                                   ? startClearance
                                   : std::min(startClearance, clearanceAt(problem.goal, ProblemEnd::kGoal));
    useCertified(setup, leastAtEnds, isOver, report);
    setup.floor = report.floor;
    setup.isStopped = [isStopped = options.isStopped] { return isStopped && isStopped(); };
    // The planners' earlier queries do not change an audit, to the last digit.
    setup.auditor = std::make_shared<MotionValidator>(setup.si, scene, auditMotions(scene, leastAtEnds));
    setup.si->setStateValidityChecker(setup.checker);
    setup.definition = defineProblem(setup, problem, scene, report.warnings);
    if (objective) {
        setup.definition->setOptimizationObjective(
            makePlanObjective(*setup.definition, setup.checker->shared(), *objective, problem, leastAtEnds));
    }
    if (beforePlanners) beforePlanners(setup);
    applySettings(*setup.si, problem, report.warnings);
    for (const std::string& name : report.planners) {
        setup.planners.push_back(setUpPlanner(setup, name, problem, options, report));
        if (hasSeveralThreads(*setup.planners.back())) report.isRepeatable = false;
    }
    return setup;
}

}  // namespace clearway::planning
