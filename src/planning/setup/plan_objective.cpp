#include "planning/setup/plan_objective.h"

#include <algorithm>
#include <stdexcept>

#include "clearway/planning/clearance_objectives.h"
#include "planning/motion/motion_search.h"

namespace clearway::planning {
namespace {

namespace ob = ompl::base;

constexpr const char* kLength = "length";

/// A path's cost may be less by the resolution than what a path can have at best.
double attainable(const MinClearanceObjective& objective, double clearanceOfEnds) {
    const Scene& scene = objective.scene();
    const double best = std::min(clearanceOfEnds, objective.cap());
    return best - 1.01 * usualResolution(scene, defaultLeastInterval(scene)).of(best);
}

}  // namespace

std::optional<ObjectiveChoice> chooseObjective(const Problem& problem, const PlanOptions& options) {
    if (!options.objective.empty()) {
        return ObjectiveChoice{objectiveName(options.objective), options.wantedClearance};
    }
    std::string name;
    try {
        name = objectiveName(problem.objective);
    } catch (const std::invalid_argument&) {
        return std::nullopt;
    }
    if (name == kLength && !problem.objectiveThreshold) return std::nullopt;
    return ObjectiveChoice{name, options.wantedClearance};
}

bool asksForClearance(const std::optional<ObjectiveChoice>& choice, const Model& part) {
    return choice && largestClearance(*choice, part) > 0;
}

ob::OptimizationObjectivePtr makePlanObjective(const ob::SpaceInformationPtr& si, const Scene& scene,
                                               const ObjectiveChoice& choice,
                                               const std::optional<double>& threshold,
                                               double clearanceOfEnds) {
    const ob::OptimizationObjectivePtr objective = makeObjective(si, scene, choice);
    const auto* least = dynamic_cast<const MinClearanceObjective*>(objective.get());
    if (least != nullptr) objective->setCostThreshold(ob::Cost(attainable(*least, clearanceOfEnds)));
    if (threshold && (least == nullptr || *threshold < objective->getCostThreshold().value())) {
        objective->setCostThreshold(ob::Cost(*threshold));
    }
    return objective;
}

}  // namespace clearway::planning
