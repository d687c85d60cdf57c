#include "planning/plan/goals.h"

#include <ompl/base/goals/GoalState.h>

#include <limits>
#include <memory>

#include "clearway/planning/outside_goal.h"
#include "planning/space/ompl_states.h"

namespace clearway::planning {

ob::GoalPtr makeGoal(const ob::SpaceInformationPtr& si, const Problem& problem, const Scene& scene) {
    if (problem.outside) return std::make_shared<OutsideGoal>(si, scene, *problem.outside, problem.start);
    const auto goal = std::make_shared<ob::GoalState>(si);
    goal->setState(toOmpl(si->getStateSpace(), problem.space, problem.goal));
    goal->setThreshold(problem.planning.goalThreshold.value_or(std::numeric_limits<double>::epsilon()));
    return goal;
}

bool isOutside(const ob::GoalPtr& goal, const ob::State* state) {
    const auto* outside = dynamic_cast<const OutsideGoal*>(goal.get());
    return outside != nullptr && outside->isSatisfied(state);
}

}  // namespace clearway::planning
