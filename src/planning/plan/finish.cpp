#include "planning/plan/finish.h"

#include <algorithm>
#include <cmath>

#include "clearway/planning/clearance_objectives.h"
#include "clearway/planning/simplify.h"
#include "planning/improve/kept_clearance.h"
#include "planning/improve/unwind.h"
#include "planning/plan/goals.h"

namespace clearway::planning {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

constexpr double kAccuracy = 0.01;  ///< of clearances, as a share

/// Audits certify small clearances only to 10 %. Here all motions are known to keep a clearance.
void raiseTo(double kept, PathAudit& found) {
    if (!found.isValid()) return;
    found.lowerClearance = std::max(found.lowerClearance, std::min(kept, found.upperClearance));
    for (SegmentAudit& segment : found.segments) {
        MotionReport& motion = segment.motion;
        motion.lowerClearance = std::max(motion.lowerClearance, std::min(kept, motion.upperClearance));
    }
}

/// Shortens a path so that all its motions still keep a clearance.
PathAudit shortenKeeping(const PlanSetup& setup, og::PathGeometric& path, double kept,
                         const std::function<bool()>& isSpent) {
    og::PathGeometric shorter = path;
    const double floor = std::max(setup.floor, kept);
    unwind(shorter, *setup.auditor, floor, isSpent);
    SimplifyOptions options{floor, isSpent};
    if (kept > 0) options.kept = kept;
    PathAudit found = simplify(shorter, *setup.auditor, options);
    const bool isExact = !setup.isStopped();
    if (isExact && kept > 0 && keptClearance(shorter, *setup.auditor, {0, kept, kAccuracy, {}}) < kept) {
        return audit(path, *setup.auditor);
    }
    path = shorter;
    if (isExact) raiseTo(kept, found);
    return found;
}

/// Keeps the path as it is when shortening makes it worse by the objective, if there is one.
PathAudit shortenUnlessWorse(const PlanSetup& setup, og::PathGeometric& path,
                             const std::function<bool()>& isSpent) {
    og::PathGeometric shorter = path;
    const PathAudit found = shortenKeeping(setup, shorter, 0, isSpent);
    const auto& objective = setup.definition->getOptimizationObjective();
    if (objective && objective->isCostBetterThan(path.cost(objective), shorter.cost(objective))) {
        return audit(path, *setup.auditor);
    }
    path = shorter;
    return found;
}

/// An audit knows small clearances only to 10 %.
double keptBy(const PlanSetup& setup, const og::PathGeometric& path, const PathAudit& found,
              const std::function<bool()>& isSpent) {
    const double least = std::max(0.0, found.lowerClearance);
    if (!std::isfinite(found.upperClearance)) return least;
    return keptClearance(path, *setup.auditor, {least, found.upperClearance, kAccuracy, isSpent});
}

bool isLeastClearance(const ob::OptimizationObjectivePtr& objective) {
    return dynamic_cast<const MinClearanceObjective*>(objective.get()) != nullptr;
}

/// Returns the cost of a path if it is better than the best. Stops as soon as the motions so far cost no
/// less, because there may be thousands of paths.
std::optional<double> costBetterThan(const std::optional<BestSolution>& best,
                                     const ob::OptimizationObjective& objective,
                                     const std::vector<ob::State*>& states) {
    const auto isWorse = [&](ob::Cost cost) {
        return best && !objective.isCostBetterThan(cost, ob::Cost(best->cost));
    };
    ob::Cost cost =
        objective.combineCosts(objective.initialCost(states.front()), objective.terminalCost(states.back()));
    for (std::size_t i = 1; i < states.size() && !isWorse(cost); ++i) {
        cost = objective.combineCosts(cost, objective.motionCost(states[i - 1], states[i]));
    }
    if (isWorse(cost)) return std::nullopt;
    return cost.value();
}

}  // namespace

std::optional<BestSolution> bestSolution(const ob::ProblemDefinition& definition) {
    const ob::OptimizationObjectivePtr& objective = definition.getOptimizationObjective();
    std::optional<BestSolution> best;
    for (const ob::PlannerSolution& solution : definition.getSolutions()) {
        if (solution.approximate_) continue;
        if (!objective) return BestSolution{solution, std::nan("")};
        auto& path = *solution.path_->as<og::PathGeometric>();
        const auto cost = costBetterThan(best, *objective, path.getStates());
        if (cost) best = BestSolution{solution, *cost};
    }
    return best;
}

ob::PlannerSolution solutionOf(const PlanSetup& setup) {
    if (const auto best = bestSolution(*setup.definition)) return best->solution;
    return setup.definition->getSolutions().at(0);
}

bool cutOutside(const PlanSetup& setup, og::PathGeometric& path) {
    for (unsigned int i = 0; i + 1 < path.getStateCount(); ++i) {
        if (!isOutside(setup.definition->getGoal(), path.getState(i))) continue;
        og::PathGeometric first(setup.si);
        for (unsigned int k = 0; k <= i; ++k) first.append(path.getState(k));
        path = first;
        return true;
    }
    return false;
}

og::PathGeometric pathOf(const PlanSetup& setup, const ob::PlannerSolution& solution) {
    og::PathGeometric path(setup.si);
    for (const ob::State* state : solution.path_->as<og::PathGeometric>()->getStates()) path.append(state);
    cutOutside(setup, path);
    return path;
}

PathAudit finish(const PlanSetup& setup, og::PathGeometric& path, const std::function<bool()>& isSpent,
                 double keptBefore) {
    if (isSpent()) {
        PathAudit found = audit(path, *setup.auditor);
        raiseTo(keptBefore, found);
        return found;
    }
    if (keptBefore > 0) return shortenKeeping(setup, path, keptBefore, isSpent);
    const auto& objective = setup.definition->getOptimizationObjective();
    if (!isLeastClearance(objective)) return shortenUnlessWorse(setup, path, isSpent);
    // Clearances above the cap are no better, and where no obstacle counts the clearance is infinite.
    const double cap = static_cast<const MinClearanceObjective&>(*objective).cap();
    const PathAudit found = audit(path, *setup.auditor);
    if (isSpent()) return found;
    const double kept = keptBy(setup, path, found, isSpent);
    const double floor = std::max(setup.floor, std::min(cap, kept));
    unwind(path, *setup.auditor, floor, isSpent);
    SimplifyOptions options{floor, isSpent};
    if (kept > 0 && std::isfinite(kept)) options.kept = kept;
    PathAudit shortened = simplify(path, *setup.auditor, options);
    if (setup.isStopped()) return shortened;
    raiseTo(std::min(kept, keptClearance(path, *setup.auditor, {0, floor, kAccuracy, {}})), shortened);
    return shortened;
}

}  // namespace clearway::planning
