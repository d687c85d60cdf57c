// The trees that planners grew from start and goal without joining them.
#pragma once

#include <ompl/base/Planner.h>
#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/ScopedState.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "clearway/planning/motion_validator.h"

namespace clearway::planning {

/// A state that the planners reached. The planners own it.
struct ReachedState {
    const ompl::base::State* state;
    int parent;  ///< index of the state that it was reached from; -1 for a root
};

/// The states reached from one end of the problem, each after its parent.
struct FailedTree {
    std::vector<ReachedState> states;
    bool isGrown = false;  ///< a planner has a tree there; else the end itself is the only state

    /// From a state to its root.
    std::vector<const ompl::base::State*> wayToRoot(std::size_t state) const;
};

struct FailedTrees {
    FailedTree start, goal;
    /// A goal that was drawn because none was given and no planner tells one: the only state of the goal's tree then.
    std::shared_ptr<ompl::base::ScopedState<>> drawnGoal;
};

/// Indices into the two trees' states.
struct ClosestStates {
    std::size_t start = 0, goal = 0;
};

/// Goes from the start and goal states of the planners' graphs along their edges, breadth first, so that a part of a
/// roadmap becomes a tree. Motions of lazy planners are checked by the validator, until isStopped, unless empty, returns true. The planners must outlive the result,
/// and stay as they are; their states must be of the definition's space. goal: a state of the goal, which must
/// outlive the result; null: one is sampled when no planner exposes a goal state. Throws ArgumentError when
/// the definition has no start or no goal, or one that cannot be drawn.
FailedTrees failedTrees(const std::vector<ompl::base::PlannerPtr>& planners,
                        const ompl::base::ProblemDefinition& definition, const MotionValidator& validator,
                        const ompl::base::State* goal, const std::function<bool()>& isStopped);

/// The pair of states with the least distance in the space. In large trees a pair for which neither state has a nearer
/// one in the other tree.
ClosestStates closestStates(const FailedTrees& trees, const ompl::base::SpaceInformation& si);

}  // namespace clearway::planning
