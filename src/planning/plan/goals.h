// The goal of a problem as OMPL's planners take it.
#pragma once

#include <ompl/base/Goal.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/geometric/PathGeometric.h>

#include "clearway/problem.h"
#include "clearway/scene.h"

namespace clearway::planning {

/// The problem's goal: a pose with the problem's threshold, or an OutsideGoal. Throws as OutsideGoal does.
ompl::base::GoalPtr makeGoal(const ompl::base::SpaceInformationPtr& si, const Problem& problem,
                             const Scene& scene);

/// True for a goal outside that the state satisfies. A path may end there.
bool isOutside(const ompl::base::GoalPtr& goal, const ompl::base::State* state);

}  // namespace clearway::planning
