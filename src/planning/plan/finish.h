// From the solutions of planners to a finished path: the best solution, shortened and audited.
#pragma once

#include <ompl/base/ProblemDefinition.h>
#include <ompl/geometric/PathGeometric.h>

#include <functional>
#include <optional>

#include "clearway/planning/audit.h"
#include "planning/plan/plan_setup.h"

namespace clearway::planning {

/// The result of bestSolution().
struct BestSolution {
    ompl::base::PlannerSolution solution;  ///< one of those of the problem definition
    double cost = 0;                       ///< by the definition's objective; NaN without one
};

/// Returns the exact solution that costs least by the definition's objective; without an objective, the first
/// exact one of OMPL's. (OMPL puts the solutions of some planners in the order of their lengths.) Nothing
/// when there is no exact solution.
std::optional<BestSolution> bestSolution(const ompl::base::ProblemDefinition& definition);

/// Returns the best exact solution, else OMPL's first solution, which is approximate. Throws
/// std::out_of_range when the definition has no solution.
ompl::base::PlannerSolution solutionOf(const PlanSetup& setup);

/// Ends a path to a goal outside with its first state there. Returns whether states were cut off.
bool cutOutside(const PlanSetup& setup, ompl::geometric::PathGeometric& path);

/// Copies the solution's states into a path in the setup's own space information: the solution's may be a
/// wrapper that dies with its planner. A path to a goal outside ends with its first state there.
ompl::geometric::PathGeometric pathOf(const PlanSetup& setup, const ompl::base::PlannerSolution& solution);

/// Takes needless rotations out of the path and shortens it until isSpent, which must not be empty, returns true, by
/// certified motions that keep setup.floor, and audits the result. The gain by the objective is kept: a shortened
/// path that costs more is dropped, and a path found for its least clearance is shortened by motions that keep that
/// clearance.
///
/// kept: a clearance that all motions of the path keep; the finished path's motions keep it too, unless setup.isStopped().
PathAudit finish(const PlanSetup& setup, ompl::geometric::PathGeometric& path,
                 const std::function<bool()>& isSpent, double kept = 0);

}  // namespace clearway::planning
