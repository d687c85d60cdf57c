#include "planning/plan/problem_settings.h"

#include <ompl/base/samplers/BridgeTestValidStateSampler.h>
#include <ompl/base/samplers/GaussianValidStateSampler.h>
#include <ompl/base/samplers/MaximizeClearanceValidStateSampler.h>
#include <ompl/base/samplers/ObstacleBasedValidStateSampler.h>
#include <ompl/base/samplers/UniformValidStateSampler.h>

#include <ompl/base/goals/GoalState.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <set>
#include <stdexcept>

#include "clearway/errors.h"
#include "clearway/planning/clearance_objectives.h"
#include "clearway/planning/planners.h"
#include "clearway/planning/valid_state_samplers.h"
#include "clearway/scene_clearance.h"
#include "core/number.h"
#include "core/text.h"
#include "planning/check/motion_resolution.h"
#include "problem/config.h"
#include "problem/start_remedies.h"

namespace clearway::planning {
namespace {

namespace ob = ompl::base;

constexpr double kFinenessPerDiagonal = 1.0 / 500;

/// The least clearance, capped by that of the ends or, where no obstacle is near, by any length. The best path is found when the
/// cost is as close to it as costs are to clearances.
ob::OptimizationObjectivePtr leastClearance(const ob::SpaceInformationPtr& si, const SharedScene& shared,
                                            double clearanceOfEnds) {
    const Scene& scene = shared.scene();
    MinClearanceOptions options;
    options.cap = std::isfinite(clearanceOfEnds)
                      ? std::max(clearanceOfEnds, std::numeric_limits<double>::min())
                      : scene.part.box().diagonal().norm();
    const auto objective = std::make_shared<MinClearanceObjective>(si, shared, options);
    const double most = objective->cap();
    objective->setCostThreshold(
        ob::Cost(most - 1.01 * usualResolution(scene, defaultLeastInterval(scene)).of(most)));
    return objective;
}

/// What no path can be better than: the way straight to the goal, or no cost where the goal is not one state.
ob::Cost boundOf(const ob::OptimizationObjective& objective, const ob::ProblemDefinition& definition) {
    if (const auto* least = dynamic_cast<const MinClearanceObjective*>(&objective))
        return ob::Cost(least->cap());
    const auto* goal = dynamic_cast<const ob::GoalState*>(definition.getGoal().get());
    if (goal == nullptr) return objective.identityCost();
    return objective.motionCostHeuristic(definition.getStartState(0), goal->getState());
}

/// OMPL's threshold 0 stands for none. A length of 0 is met by no path, so planners go on to the end of their time; the least clearance
/// keeps its own threshold.
void useThreshold(ob::OptimizationObjective& objective, const Problem& problem,
                  const ob::ProblemDefinition& definition, const std::string& unit) {
    const ob::Cost threshold(*problem.planning.objectiveThreshold), bound = boundOf(objective, definition);
    if (threshold.value() != 0 && objective.isCostBetterThan(threshold, bound)) {
        throw ArgumentError(problem.file + ": objective.threshold is " + shortNumber(threshold.value()) +
                            ", which no path meets: " + problem.planning.objective + " is at best " +
                            withUnit(roundedNumber(bound.value()), unit) + " between start and goal");
    }
    const bool isLeast = dynamic_cast<const MinClearanceObjective*>(&objective) != nullptr;
    if (!isLeast || (threshold.value() != 0 && threshold.value() < objective.getCostThreshold().value()))
        objective.setCostThreshold(threshold);
}

template <class Sampler>
ob::ValidStateSamplerPtr allocate(const ob::SpaceInformation* si) {
    return std::make_shared<Sampler>(si);
}

struct NamedSampler {
    const char* name;
    ob::ValidStateSamplerPtr (*allocate)(const ob::SpaceInformation*);
};

constexpr NamedSampler kSamplers[] = {
    {"uniform", allocate<ob::UniformValidStateSampler>},
    {"gaussian", allocate<ob::GaussianValidStateSampler>},
    {"obstacle_based", allocate<ob::ObstacleBasedValidStateSampler>},
    {"max_clearance", allocate<ob::MaximizeClearanceValidStateSampler>},
    {"bridge_test", allocate<ob::BridgeTestValidStateSampler>},
    {"contact_normal", allocate<ContactNormalSampler>},
    {"narrow_gap", allocate<NarrowGapSampler>},
};

const NamedSampler& findSampler(const std::string& name) {
    for (const NamedSampler& row : kSamplers) {
        if (name == row.name) return row;
    }
    const std::vector<std::string> known = namesOf(kSamplers);
    throw ArgumentError("unknown sampler '" + name + "'" + didYouMean(name, known) + ", expected one of " +
                        joined(known));
}

/// Sets the values that belong to the parameters, and returns their names.
std::set<std::string> apply(ob::ParamSet& parameters, const NamedTexts& settings) {
    std::set<std::string> known;
    for (const auto& [name, value] : settings) {
        if (!parameters.hasParam(name)) continue;
        known.insert(name);
        bool isSet = false;
        try {
            isSet = parseNumber(value) && parameters.setParam(name, value);
        } catch (const std::exception&) {  // a number out of OMPL's range
        }
        if (isSet) continue;
        throw ArgumentError("the problem's setting " + name + " is '" + value +
                            "', expected a number that OMPL takes");
    }
    return known;
}

}  // namespace

Problem problemFor(const std::string& planner, const Problem& problem) {
    Problem result = problem;
    const auto choice =
        std::find_if(problem.planning.planners.begin(), problem.planning.planners.end(),
                     [&](const PlannerChoice& each) { return plannerClassName(each.name) == planner; });
    if (choice == problem.planning.planners.end()) return result;
    for (const auto& [name, value] : choice->settings) {
        if (name == "sampler") {
            result.planning.sampler = value;
        } else if (name == "objective.threshold") {
            result.planning.objectiveThreshold = parseNumber(value);
        } else {
            result.planning.settings.emplace_back(name, value);  // the later value counts
        }
    }
    return result;
}

bool mayUseSampler(const Problem& problem, const std::string& sampler) {
    const std::pair<std::string, std::string> wanted("sampler", sampler);
    return problem.planning.sampler == sampler ||
           std::any_of(problem.planning.planners.begin(), problem.planning.planners.end(),
                       [&](const PlannerChoice& planner) {
                           const NamedTexts& settings = planner.settings;
                           return std::find(settings.begin(), settings.end(), wanted) != settings.end();
                       });
}

void setSampler(ob::SpaceInformation& si, const std::string& name,
                const std::function<void(ob::ValidStateSampler&)>& adjust) {
    if (name.empty()) return;
    si.setValidStateSamplerAllocator(
        [adjust, allocate = findSampler(name).allocate](const ob::SpaceInformation* space) {
            const ob::ValidStateSamplerPtr sampler = allocate(space);
            adjust(*sampler);
            return sampler;
        });
}

void requireSampler(const std::string& name) {
    findSampler(name);
}

void applySettings(ob::SpaceInformation& si, const Problem& problem, std::vector<std::string>& warnings) {
    std::set<std::string> known = apply(si.getStateSpace()->params(), problem.planning.settings);
    const bool isDefault = problem.planning.sampler.empty() && !problem.planning.settings.empty();
    setSampler(si, isDefault ? "uniform" : problem.planning.sampler,
               [settings = problem.planning.settings](ob::ValidStateSampler& sampler) {
                   apply(sampler.params(), settings);
               });
    si.setup();
    known.merge(apply(si.params(), problem.planning.settings));  // projections come with the setup
    known.merge(apply(si.allocValidStateSampler()->params(), problem.planning.settings));
    for (const auto& [name, value] : problem.planning.settings) {
        if (known.count(name)) continue;
        warnings.push_back(problem.file + ": neither the space nor the sampler has a setting '" + name +
                           "'; it is left out");
    }
}

namespace {

/// Names the keys of [clearway] that let the problem begin at its start, which is in collision.
InvalidStart refusedStart(const std::string& message, const Problem& problem, const ValidityChecker& checker,
                          const ob::State* start) {
    const Scene& scene = checker.scene();
    const SceneDistance nearest = checker.distance(start);
    std::vector<std::string> names = touchedObstacles(scene, poseOf(problem.start));
    if (names.empty()) names.push_back(meshNames(scene, nearest).environment);
    const double margin = scene.largestMargin();
    const double length = kUsualContact * scene.part.box().diagonal().norm() + 2 * margin;
    const bool mayOverlap = nearest.collides() && margin == 0;
    return {message + startAdvice(problem, names, length, mayOverlap), mayOverlap};
}

}  // namespace

double requireValid(const Problem& problem, const ValidityChecker& checker, const ob::State* state,
                    ProblemEnd end) {
    double clearance = 0;
    if (checker.isValid(state, clearance)) return clearance;
    const WhyInvalid why = checker.whyInvalid(state);
    const bool isStart = end == ProblemEnd::kStart;
    const std::string message = (isStart ? "start is " : "goal is ") + why.words();
    if (isStart && why.isCollision()) throw refusedStart(message, problem, checker, state);
    throw ArgumentError(message);
}

double finenessOf(const Problem& problem, const Model& part) {
    return problem.fineness.value_or(kFinenessPerDiagonal * part.box().diagonal().norm());
}

void requireRangeOf(const Scene& scene, const Box& bounds, double fineness) {
    for (const Obstacle& obstacle : scene.obstacles) {
        if (!obstacle.model.range()) continue;
        const QueryRange& range = *obstacle.model.range();
        if (!range.positions.contains(bounds)) {
            throw ArgumentError(
                "the environment was built with a range that leaves out positions within the bounds, "
                "expected one that holds them all");
        }
        if (!(range.cap >= obstacle.margin + fineness)) {
            throw ArgumentError("the environment was built with a range whose cap is " +
                                withUnit(shortNumber(range.cap), scene.unit) +
                                ", expected at least the margin and the fineness, " +
                                withUnit(shortNumber(obstacle.margin + fineness), scene.unit));
        }
    }
}

std::optional<ObjectiveChoice> chooseObjective(const Problem& problem, const PlanOptions& options) {
    if (!options.objective.empty()) {
        return ObjectiveChoice{objectiveName(options.objective), options.wantedClearance};
    }
    std::string name;
    try {
        name = objectiveName(problem.planning.objective);
    } catch (const std::invalid_argument&) {
        return std::nullopt;
    }
    if (name == "length" && !problem.planning.objectiveThreshold) return std::nullopt;
    return ObjectiveChoice{name, options.wantedClearance};
}

ob::OptimizationObjectivePtr makePlanObjective(const ob::ProblemDefinition& definition,
                                               const SharedScene& scene, const ObjectiveChoice& choice,
                                               const Problem& problem, double clearanceOfEnds) {
    const ob::SpaceInformationPtr& si = definition.getSpaceInformation();
    const ob::OptimizationObjectivePtr objective = choice.name == kLeastClearance
                                                       ? leastClearance(si, scene, clearanceOfEnds)
                                                       : makeObjective(si, scene, choice);
    const auto own = chooseObjective(problem, {});
    if (problem.planning.objectiveThreshold && own && own->name == choice.name)
        useThreshold(*objective, problem, definition, scene.scene().unit);
    return objective;
}

}  // namespace clearway::planning
