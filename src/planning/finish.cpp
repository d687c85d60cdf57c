#include "planning/finish.h"

#include <algorithm>

#include "clearway/planning/clearance_objectives.h"
#include "clearway/planning/simplify.h"
#include "planning/objectives.h"
#include "planning/shorten.h"

namespace clearway::planning {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

bool passesSteps(const Setup& setup, const og::PathGeometric& path) {
    for (unsigned int i = 1; i < path.getStateCount(); ++i) {
        if (!setup.discrete->checkMotion(path.getState(i - 1), path.getState(i))) return false;
    }
    return true;
}

PathAudit shortenBySteps(const Setup& setup, og::PathGeometric& path, const std::function<bool()>& isSpent) {
    og::PathGeometric shorter = path;
    shorten(shorter, isSpent);
    PathAudit found = audit(shorter, *setup.auditor);
    if (!found.isValid()) {
        PathAudit own = audit(path, *setup.auditor);
        if (own.isValid() || !passesSteps(setup, shorter)) return own;
    }
    path = shorter;
    return found;
}

/// The clearance that shortening keeps.
double floorOf(const Setup& setup, const og::PathGeometric& path) {
    const auto& objective = setup.definition->getOptimizationObjective();
    if (dynamic_cast<const MinClearanceObjective*>(objective.get()) == nullptr) return setup.floor;
    return std::max(setup.floor, audit(path, *setup.auditor).lowerClearance);
}

}  // namespace

ob::PlannerSolution solutionOf(const Setup& setup) {
    if (const auto best = bestSolution(*setup.definition)) return best->solution;
    return setup.definition->getSolutions().at(0);
}

og::PathGeometric pathOf(const Setup& setup, const ob::PlannerSolution& solution) {
    og::PathGeometric path(setup.si);
    for (const ob::State* state : solution.path_->as<og::PathGeometric>()->getStates()) path.append(state);
    return path;
}

PathAudit finish(const Setup& setup, og::PathGeometric& path, const std::function<bool()>& isSpent) {
    og::PathGeometric shorter = path;
    const double floor = floorOf(setup, path);
    const PathAudit found = setup.discrete ? shortenBySteps(setup, shorter, isSpent)
                                           : simplify(shorter, *setup.auditor, {floor, isSpent});
    const auto& objective = setup.definition->getOptimizationObjective();
    const bool isKept = !setup.discrete && floor > setup.floor;  // but for the resolution of costs
    if (objective && !isKept && objective->isCostBetterThan(path.cost(objective), shorter.cost(objective))) {
        return audit(path, *setup.auditor);
    }
    path = shorter;
    return found;
}

}  // namespace clearway::planning
