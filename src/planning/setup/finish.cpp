#include "planning/setup/finish.h"

#include <algorithm>
#include <cmath>

#include "clearway/planning/clearance_objectives.h"
#include "clearway/planning/simplify.h"
#include "planning/objectives/objectives.h"
#include "planning/paths/shorten.h"

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

/// By the objective, if there is one.
PathAudit shortenUnlessWorse(const Setup& setup, og::PathGeometric& path,
                             const std::function<bool()>& isSpent) {
    og::PathGeometric shorter = path;
    const PathAudit found = setup.discrete ? shortenBySteps(setup, shorter, isSpent)
                                           : simplify(shorter, *setup.auditor, {setup.floor, isSpent});
    const auto& objective = setup.definition->getOptimizationObjective();
    if (objective && objective->isCostBetterThan(path.cost(objective), shorter.cost(objective))) {
        return audit(path, *setup.auditor);
    }
    path = shorter;
    return found;
}

bool keepsAll(const Setup& setup, const og::PathGeometric& path, double clearance) {
    for (unsigned int i = 1; i < path.getStateCount(); ++i) {
        if (!setup.auditor->keepsClearance(path.getState(i - 1), path.getState(i), clearance)) return false;
    }
    return true;
}

/// What all motions of the path keep, to 1 % if time allows: an audit tells of small clearances to 10 %.
double keptBy(const Setup& setup, const og::PathGeometric& path, const PathAudit& found,
              const std::function<bool()>& isSpent) {
    double kept = std::max(0.0, found.lowerClearance), most = found.upperClearance;
    while (std::isfinite(most) && most - kept > 0.01 * most && !isSpent()) {
        const double middle = kept + 0.5 * (most - kept);
        (keepsAll(setup, path, middle) ? kept : most) = middle;
    }
    return kept;
}

bool isLeastClearance(const ob::OptimizationObjectivePtr& objective) {
    return dynamic_cast<const MinClearanceObjective*>(objective.get()) != nullptr;
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
    if (setup.discrete) return shortenUnlessWorse(setup, path, isSpent);
    const auto& objective = setup.definition->getOptimizationObjective();
    if (!isLeastClearance(objective)) return shortenUnlessWorse(setup, path, isSpent);
    // More than the cap is as good, and where nothing counts there is no end to it.
    const double cap = static_cast<const MinClearanceObjective&>(*objective).cap();
    const PathAudit found = audit(path, *setup.auditor);
    if (isSpent()) return found;
    const double kept = keptBy(setup, path, found, isSpent);
    const double floor = std::max(setup.floor, std::min(cap, kept));
    return simplify(path, *setup.auditor, {floor, isSpent});
}

}  // namespace clearway::planning
