// What becomes of a planner's path: shortened, and looked at again along its whole length.
#pragma once

#include <ompl/geometric/PathGeometric.h>

#include <functional>

#include "clearway/planning/audit.h"
#include "planning/setup/setup.h"

namespace clearway::planning {

/// Of all solutions the best by the objective, if there is one, else OMPL's first.
ompl::base::PlannerSolution solutionOf(const Setup& setup);

/// The solution's states, in the setup's own space information: that of the solution may be a wrapper that
/// dies with its planner.
ompl::geometric::PathGeometric pathOf(const Setup& setup, const ompl::base::PlannerSolution& solution);

/// Shortens the path, by certified motions that keep setup.floor, or in the setup's steps, until isSpent says
/// so, and audits what it then is. With steps the planner's own path is kept when it alone is valid along its
/// whole length, or the shortened one does not pass its steps (OMPL's shortcuts have collided). What the
/// objective is about is not lost: its own path is also kept when the shortened one costs more, and a path
/// found for its least clearance is shortened by motions that keep that.
PathAudit finish(const Setup& setup, ompl::geometric::PathGeometric& path,
                 const std::function<bool()>& isSpent);

}  // namespace clearway::planning
