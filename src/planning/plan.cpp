#include "planning/plan.h"

#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/util/RandomNumbers.h>

#include <atomic>
#include <boost/algorithm/string/predicate.hpp>
#include <chrono>
#include <cmath>
#include <memory>
#include <sstream>
#include <stdexcept>

#include "clearway/planning/discrete_motion_validator.h"
#include "clearway/planning/planners.h"
#include "clearway/planning/validity_checker.h"
#include "core/number.h"
#include "planning/end_states.h"
#include "planning/ompl_messages.h"
#include "planning/planning_space.h"
#include "planning/simplify.h"
#include "planning/walk.h"

namespace clearway::planning {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;
using Clock = std::chrono::steady_clock;

constexpr const char* kDefaultPlanner = "RRTConnect";
constexpr double kDefaultStepPerDiagonal = 1.0 / 500;
constexpr double kMostRefinement = 8;  ///< times the step is divided for a tight start or goal
constexpr double kRangePerDiagonal =
    0.25;  ///< longest edge of a planner's tree; see tests/bench/plan_success.cpp

double secondsSince(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// When the planner has to end. Asked from several threads by some planners.
class Budget {
  public:
    explicit Budget(const PlanOptions& options) : options_(options), begin_(Clock::now()) {
        if (!options.iterations) seconds_ = options.seconds.value_or(kDefaultSeconds);
    }

    bool isStopped() const { return options_.isStopped && options_.isStopped(); }
    bool isOutOfTime() const { return isStopped() || (seconds_ && secondsSince(begin_) >= *seconds_); }
    bool spendIteration() {
        return isOutOfTime() || (options_.iterations && ++asked_ > *options_.iterations);
    }

  private:
    const PlanOptions& options_;
    Clock::time_point begin_;
    std::optional<double> seconds_;
    std::atomic<std::uint64_t> asked_{0};
};

/// What planning and finishing share.
struct Setup {
    ob::StateSpacePtr space;
    ob::SpaceInformationPtr si;
    std::shared_ptr<ValidityChecker> checker;  ///< with the guard on top of the margin: the planner's
    std::shared_ptr<ValidityChecker> truth;    ///< with the margin itself
    std::shared_ptr<DiscreteMotionValidator> validator;
    ob::ProblemDefinitionPtr definition;
    ob::PlannerPtr planner;
};

void requireOptions(const Problem& problem, const PlanOptions& options) {
    if (options.seed == 0) throw std::invalid_argument("seed is 0, expected a whole number above 0");
    if (options.seconds && options.iterations) {
        throw std::invalid_argument("both a time and a number of iterations are given, expected one of them");
    }
    if (options.seconds && !(*options.seconds > 0)) {
        throw std::invalid_argument("time is " + std::to_string(*options.seconds) +
                                    ", expected seconds above 0");
    }
    for (const PlannerChoice& choice : problem.planners) {
        try {
            plannerClassName(choice.name);
        } catch (const std::invalid_argument& error) {
            throw std::invalid_argument(problem.file + ": " + error.what());
        }
    }
}

/// A second call in a process makes OMPL complain: objects made before it would go on with their old seeds.
/// Ours are made after it.
void setSeed(std::uint32_t seed) {
    const OmplMessages unheard;
    ompl::RNG::setSeed(seed);
}

std::string choosePlanner(const Problem& problem, const PlanOptions& options) {
    if (!options.planner.empty()) return plannerClassName(options.planner);
    return plannerClassName(problem.planners.size() == 1 ? problem.planners[0].name : kDefaultPlanner);
}

/// Default range, then the .cfg's parameters (unknown ones are warned of), then the options' own.
void setParameters(ob::Planner& planner, const Problem& problem, const PlanOptions& options, double range,
                   PlanReport& report) {
    if (hasParameter(planner, "range")) setParameter(planner, "range", formatNumber(range));
    for (const PlannerChoice& choice : problem.planners) {
        if (plannerClassName(choice.name) != report.planner) continue;
        for (const auto& [name, value] : choice.parameters) {
            if (name == "name") continue;  // a label for benchmark logs
            if (hasParameter(planner, name)) {
                setParameter(planner, name, value);
            } else {
                report.warnings.push_back(problem.file + ": planner " + report.planner +
                                          " has no parameter '" + name + "'; it is left out");
            }
        }
        break;  // a planner named several times is several runs of a benchmark: the first one counts
    }
    for (const auto& [name, value] : options.parameters) setParameter(planner, name, value);
}

void setStep(PlanReport& report, const Problem& problem, const Scene& scene, const PlanOptions& options) {
    const std::optional<double> given = options.step ? options.step : problem.step;
    report.isStepDefault = !given;
    report.step = given ? *given : kDefaultStepPerDiagonal * scene.part.box().diagonal().norm();
    if (!report.isStepDefault) return;
    std::ostringstream warning;
    warning << "no step is given: motions are checked every " << report.step
            << ", 1/500 of the part's diagonal; walls thinner than that may be jumped";
    report.warnings.push_back(warning.str());
}

std::shared_ptr<ValidityChecker> makeChecker(const ob::SpaceInformationPtr& si, const Scene& scene,
                                             double guard) {
    Scene guarded = scene;
    guarded.margin += guard;
    return std::make_shared<ValidityChecker>(si, guarded);
}

/// Between two checked states no point is farther than half a step from where it is at one of them. So when
/// the checked states keep half a step more than the margin, every state between them keeps the margin. Start
/// and goal must have as much to spare: the step is shortened for them, within reason; beyond it the checked
/// states alone are known to be valid.
void setGuard(PlanReport& report, double spare) {
    const double asked = report.step;
    std::ostringstream warning;
    warning << "start or goal have only " << spare << " to spare: ";
    report.guard = std::min(0.5 * asked, 0.9 * spare);
    if (report.guard == 0.5 * asked) return;
    if (report.guard < 0.5 * asked / kMostRefinement) {
        report.guard = 0;
        warning << "the states checked are known to be valid, not those between them";
    } else {
        report.step = 2 * report.guard;
        warning << "motions are checked every " << report.step << " instead of every " << asked;
    }
    report.warnings.push_back(warning.str());
}

Setup prepare(const Problem& problem, const Scene& scene, const PlanOptions& options, PlanReport& report) {
    const double turnWeight = options.omplWeights ? 1.0 : scene.part.radiusAboutOrigin();
    Setup setup;
    setup.space = makeSpace(problem.space, boundsOf(problem, scene.environment.box()), turnWeight);
    setup.si = std::make_shared<ob::SpaceInformation>(setup.space);
    const ob::ScopedState<> start = toOmpl(setup.space, problem.space, problem.start);
    const ob::ScopedState<> goal = toOmpl(setup.space, problem.space, problem.goal);

    setStep(report, problem, scene, options);
    setup.truth = makeChecker(setup.si, scene, 0);
    const double startSpare = requireValid(*setup.truth, start.get(), "start");
    setGuard(report, std::min(startSpare, requireValid(*setup.truth, goal.get(), "goal")));
    setup.checker = makeChecker(setup.si, scene, report.guard * (1 + 1e-6));
    setup.validator = std::make_shared<DiscreteMotionValidator>(setup.si, scene.part, report.step);
    setup.si->setStateValidityChecker(setup.checker);
    setup.si->setMotionValidator(setup.validator);
    setSampler(*setup.si, problem.sampler);
    setup.si->setup();

    setup.definition = std::make_shared<ob::ProblemDefinition>(setup.si);
    setup.definition->setStartAndGoalStates(start, goal);
    if (options.optimiseLength || problem.objectiveThreshold) {
        const auto objective = std::make_shared<ob::PathLengthOptimizationObjective>(setup.si);
        if (problem.objectiveThreshold) objective->setCostThreshold(ob::Cost(*problem.objectiveThreshold));
        setup.definition->setOptimizationObjective(objective);
    }
    setup.planner = makePlanner(setup.si, report.planner);
    setParameters(*setup.planner, problem, options, kRangePerDiagonal * scene.part.box().diagonal().norm(),
                  report);
    setup.planner->setProblemDefinition(setup.definition);
    setup.planner->setup();
    return setup;
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
    report.least.lower = walk.least.lower;
    report.least.statesChecked = walk.states;
    report.least.partMesh = meshName(scene.part, walk.least.partComponent);
    report.least.environmentMesh = meshName(scene.environment, walk.least.environmentComponent);
}

/// Simplifies, then looks at every state again; the planner's own path when the simplified one does not pass.
void finish(const Setup& setup, const Problem& problem, const Budget& budget, PlanReport& report) {
    auto& raw = *setup.definition->getSolutionPath()->as<og::PathGeometric>();
    report.statesBefore = raw.getStateCount();
    const auto isStopped = [&] { return budget.isStopped(); };
    og::PathGeometric path = raw;
    simplify(setup.si, path, [&] { return budget.isOutOfTime(); });
    const int refine =
        report.guard > 0 ? 2 : 1;  // with a guard the states between the checked ones must pass as well
    auto walked = walk(path, *setup.truth, *setup.validator, refine, isStopped);
    if (!walked && !isStopped()) {
        report.warnings.push_back(
            "the simplified path did not pass its re-check; the planner's own path is used");
        path = raw;
        walked = walk(path, *setup.truth, *setup.validator, refine, isStopped);
    }
    if (isStopped()) {
        report.outcome = PlanReport::Outcome::kStopped;
    } else if (!walked) {
        report.warnings.push_back("the planner's path did not pass its re-check; it counts as none");
    } else {
        describe(setup, problem, path, *walked, report);
        report.outcome = PlanReport::Outcome::kFound;
    }
}

}  // namespace

PlanReport plan(const Problem& problem, const Scene& scene, const PlanOptions& options) {
    requireOptions(problem, options);
    PlanReport report;
    report.planner = choosePlanner(problem, options);
    report.isRepeatable = isRepeatable(report.planner) && options.iterations;
    if (problem.objective != "length") {
        report.warnings.push_back("objective '" + problem.objective +
                                  "' is not known; paths are judged by length");
    }

    setSeed(options.seed);
    const OmplMessages messages;
    Setup setup = prepare(problem, scene, options, report);

    const Clock::time_point begin = Clock::now();
    Budget budget(options);
    setup.planner->solve(ob::PlannerTerminationCondition([&] { return budget.spendIteration(); }));
    report.planningSeconds = secondsSince(begin);

    const Clock::time_point planned = Clock::now();
    if (budget.isStopped()) {
        report.outcome = PlanReport::Outcome::kStopped;
    } else if (setup.definition->hasExactSolution()) {
        finish(setup, problem, budget, report);
    }
    report.finishingSeconds = secondsSince(planned);
    report.checks = setup.checker->counters().checks + setup.truth->counters().checks;
    for (const std::string& warning : messages.warnings()) report.warnings.push_back("OMPL: " + warning);
    return report;
}

Scene loadScene(const Problem& problem, const BuildOptions& buildOptions) {
    return {Model::build(loadPart(problem), buildOptions),
            Model::build(loadEnvironment(problem), buildOptions), problem.margin};
}

}  // namespace clearway::planning
