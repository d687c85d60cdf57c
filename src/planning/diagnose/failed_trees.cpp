#include "planning/diagnose/failed_trees.h"

#include <ompl/base/PlannerData.h>
#include <ompl/base/goals/GoalSampleableRegion.h>
#include <ompl/datastructures/NearestNeighborsGNATNoThreadSafety.h>
#include <ompl/geometric/planners/cforest/CForest.h>
#include <ompl/geometric/planners/kpiece/LBKPIECE1.h>
#include <ompl/geometric/planners/prm/LazyPRM.h>
#include <ompl/geometric/planners/rrt/LazyRRT.h>
#include <ompl/geometric/planners/sbl/SBL.h>
#include <ompl/geometric/planners/sbl/pSBL.h>

#include <algorithm>
#include <functional>
#include <limits>

#include "clearway/errors.h"

namespace clearway::planning {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

/// States of the start's tree whose nearest state in the goal's tree is looked up, and those of the goal's tree among which
/// it is: this takes about 0.2 s.
constexpr std::size_t kMostLookedUp = 4000, kMostLookedAt = 10000;

/// Motions of lazy planners that are checked, for each planner. States beyond them do not count as reached.
constexpr std::size_t kMostLazyMotions = 5000;

template <class Planner>
bool is(const ob::Planner& planner) {
    return dynamic_cast<const Planner*>(&planner) != nullptr;
}

/// The states of CForest's planners are wrapped; those of its space information are not.
bool tellsItsStates(const ob::Planner& planner) {
    return !is<og::CForest>(planner);
}

/// Lazy planners have motions in their trees that they never checked.
bool isLazy(const ob::Planner& planner) {
    return is<og::SBL>(planner) || is<og::pSBL>(planner) || is<og::LBKPIECE1>(planner) ||
           is<og::LazyPRM>(planner) || is<og::LazyRRT>(planner);
}

/// FMT calls every state a start that it did not connect.
bool isStart(const ob::PlannerData& data, unsigned int vertex, const ob::ProblemDefinition& definition) {
    return data.isStartVertex(vertex) && definition.getSpaceInformation()->equalStates(
                                             definition.getStartState(0), data.getVertex(vertex).getState());
}

/// A planner that found no path may still call the end of its best approach a goal.
bool isGoal(const ob::PlannerData& data, unsigned int vertex, const ob::Goal& goal) {
    return data.isGoalVertex(vertex) && goal.isSatisfied(data.getVertex(vertex).getState());
}

/// Says whether a motion of a planner's graph is valid.
using MotionCheck = std::function<bool(const ob::State* from, const ob::State* to)>;

/// A part of a planner's graph on its way into a tree.
struct Growing {
    FailedTree& tree;
    std::vector<unsigned int> vertices{};  ///< of the tree's states from `first` on
    std::size_t first = 0, next = 0;

    void add(const ob::PlannerData& data, unsigned int vertex, int parent) {
        tree.states.push_back({data.getVertex(vertex).getState(), parent});
        vertices.push_back(vertex);
    }
};

std::vector<unsigned int> neighboursOf(const ob::PlannerData& data, unsigned int vertex) {
    std::vector<unsigned int> neighbours, incoming;
    data.getEdges(vertex, neighbours);
    data.getIncomingEdges(vertex, incoming);
    neighbours.insert(neighbours.end(), incoming.begin(), incoming.end());
    return neighbours;
}

/// Takes the oldest state that was not yet looked at, and adds its neighbours that no tree has.
void grow(Growing& growing, const ob::PlannerData& data, const MotionCheck& isValid,
          std::vector<bool>& isTaken) {
    const auto parent = static_cast<int>(growing.first + growing.next);
    const unsigned int vertex = growing.vertices[growing.next++];
    for (const unsigned int neighbour : neighboursOf(data, vertex)) {
        if (isTaken[neighbour]) continue;
        if (!isValid(data.getVertex(vertex).getState(), data.getVertex(neighbour).getState())) continue;
        isTaken[neighbour] = true;
        growing.add(data, neighbour, parent);
    }
}

void addTrees(const ob::PlannerData& data, const ob::ProblemDefinition& definition,
              const MotionCheck& isValid, FailedTrees& trees) {
    Growing start{trees.start}, end{trees.goal};
    start.first = trees.start.states.size();
    end.first = trees.goal.states.size();
    std::vector<bool> isTaken(data.numVertices(), false);
    for (unsigned int i = 0; i < data.numVertices(); ++i) {
        const bool isRoot = isStart(data, i, definition);
        if (!isRoot && !isGoal(data, i, *definition.getGoal())) continue;
        isTaken[i] = true;
        (isRoot ? start : end).add(data, i, -1);
    }
    trees.start.isGrown = trees.start.isGrown || !start.vertices.empty();
    trees.goal.isGrown = trees.goal.isGrown || !end.vertices.empty();
    for (Growing* growing : {&start, &end}) {
        while (growing->next < growing->vertices.size()) grow(*growing, data, isValid, isTaken);
    }
}

/// A goal need not be a region, nor a region one to draw from.
std::shared_ptr<ob::ScopedState<>> drawnGoal(const ob::ProblemDefinition& definition) {
    const auto* goal = dynamic_cast<const ob::GoalSampleableRegion*>(definition.getGoal().get());
    if (goal == nullptr || !goal->canSample()) {
        throw ArgumentError(
            "no state of the goal is known: it draws none and refuses the problem's goal, expected a "
            "GoalSampleableRegion with states, or a goal that the problem's pose satisfies");
    }
    const auto state = std::make_shared<ob::ScopedState<>>(definition.getSpaceInformation());
    goal->sampleGoal(state->get());
    return state;
}

}  // namespace

std::vector<const ob::State*> FailedTree::wayToRoot(std::size_t state) const {
    std::vector<const ob::State*> way;
    for (int i = static_cast<int>(state); i >= 0; i = states[static_cast<std::size_t>(i)].parent) {
        way.push_back(states[static_cast<std::size_t>(i)].state);
    }
    return way;
}

FailedTrees failedTrees(const std::vector<ob::PlannerPtr>& planners, const ob::ProblemDefinition& definition,
                        const MotionValidator& validator, const ob::State* goal,
                        const std::function<bool()>& isStopped) {
    if (definition.getStartStateCount() == 0 || !definition.getGoal())
        throw ArgumentError("the problem definition lacks a start or a goal, expected both");
    FailedTrees trees;
    for (const ob::PlannerPtr& planner : planners) {
        if (!tellsItsStates(*planner)) continue;
        ob::PlannerData data(planner->getSpaceInformation());
        planner->getPlannerData(data);
        std::size_t checked = 0;
        const auto isValid = [&](const ob::State* from, const ob::State* to) {
            return !isLazy(*planner) || (checked++ < kMostLazyMotions && !(isStopped && isStopped()) &&
                                         validator.checkMotion(from, to));
        };
        addTrees(data, definition, isValid, trees);
    }
    const auto addRoot = [](FailedTree& tree, const ob::State* root) {
        if (tree.states.empty()) tree.states.push_back({root, -1});
    };
    addRoot(trees.start, definition.getStartState(0));
    if (trees.goal.states.empty() && goal == nullptr) {
        trees.drawnGoal = drawnGoal(definition);
        goal = trees.drawnGoal->get();
    }
    addRoot(trees.goal, goal);
    return trees;
}

ClosestStates closestStates(const FailedTrees& trees, const ob::SpaceInformation& si) {
    const std::vector<ReachedState>&from = trees.start.states, &to = trees.goal.states;
    const auto distance = [&](const ReachedState* a, const ReachedState* b) {
        return si.distance(a->state, b->state);
    };
    const ReachedState *a = &from[0], *b = &to[0];
    double least = std::numeric_limits<double>::infinity();
    const auto keepNearer = [&](const ReachedState* x, const ReachedState* y) {
        const double apart = distance(x, y);
        if (apart >= least) return false;
        least = apart;
        a = x;
        b = y;
        return true;
    };
    const auto strideOf = [](const std::vector<ReachedState>& states, std::size_t most) {
        return 1 + (states.size() - 1) / most;
    };
    const std::size_t fromStride = strideOf(from, kMostLookedUp), toStride = strideOf(to, kMostLookedAt);
    ompl::NearestNeighborsGNATNoThreadSafety<const ReachedState*> goal;
    goal.setDistanceFunction(distance);
    for (std::size_t i = 0; i < to.size(); i += toStride) goal.add(&to[i]);
    for (std::size_t i = 0; i < from.size(); i += fromStride) keepNearer(&from[i], goal.nearest(&from[i]));
    // States between those looked up may be nearer: each end of the pair in turn moves to the nearest state.
    bool isNearer = fromStride > 1 || toStride > 1;
    while (isNearer) {
        isNearer = false;
        for (const ReachedState& state : from) isNearer = keepNearer(&state, b) || isNearer;
        for (const ReachedState& state : to) isNearer = keepNearer(a, &state) || isNearer;
    }
    return {static_cast<std::size_t>(a - from.data()), static_cast<std::size_t>(b - to.data())};
}

}  // namespace clearway::planning
