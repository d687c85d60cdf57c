#include "clearway/planning/why_no_path.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "planning/diagnose/failed_trees.h"
#include "planning/diagnose/what_blocks.h"
#include "planning/planners/planner_team.h"
#include "planning/planners/twist_search.h"
#include "planning/space/ompl_refusal.h"
#include "planning/space/ompl_states.h"

namespace clearway::planning {
namespace {

/// The part's origin is at a bound when it is within this share of the part's diagonal of it.
constexpr double kTouchPerDiagonal = 1e-3;

/// Room for rounding in the quick bound of a displacement.
constexpr double kRounding = 1e-9;

/// No vertex moves further than the origin does, plus what the rotation moves the outermost vertex: the chord
/// 2 R sin(angle / 2), which is R / sqrt(2) times the Frobenius norm of the rotations' difference.
double mostDisplacement(const Pose& a, const Pose& b, double radius) {
    return (b.translation - a.translation).norm() +
           radius * std::sqrt(0.5) * (b.rotation - a.rotation).norm();
}

/// The exact displacement is asked for only where its quick bound is above the most so far: seldom in large trees.
double farthestIn(const FailedTree& tree, const MotionValidator& validator, const ob::State* end) {
    const Model& part = validator.scene().part;
    const Pose from = validator.pose(end);
    double farthest = 0;
    for (const ReachedState& reached : tree.states) {
        const Pose to = validator.pose(reached.state);
        const double most = mostDisplacement(from, to, part.radiusAboutOrigin());
        if (most * (1 + kRounding) <= farthest) continue;
        farthest = std::max(farthest, part.displacement(from, to));
    }
    return farthest;
}

std::vector<BoxSide> touchedBounds(const PartState& state, Space kind, const ob::RealVectorBounds& bounds,
                                   double tolerance) {
    std::vector<BoxSide> touched;
    for (int axis = 0; axis < (kind == Space::kSe2 ? 2 : 3); ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        const double at = state.position[axis];
        if (at - bounds.low[i] <= tolerance) touched.push_back({axis, false});
        if (bounds.high[i] - at <= tolerance) touched.push_back({axis, true});
    }
    return touched;
}

ReachedFrom reachedFrom(const FailedTree& tree, const FailedPlanning& failed, const Problem& problem,
                        const PartState& end) {
    ReachedFrom reached;
    reached.states = tree.states.size();
    reached.hasTree = tree.isGrown;
    const auto state = toOmpl(failed.definition->getSpaceInformation()->getStateSpace(), problem.space, end);
    reached.farthest = farthestIn(tree, *failed.validator, state.get());
    const double diagonal = failed.validator->scene().part.box().diagonal().norm();
    reached.bounds =
        touchedBounds(end, problem.space, positionBounds(problem.space, failed.validator->space()),
                      kTouchPerDiagonal * diagonal);
    return reached;
}

void findNearestMiss(const FailedTrees& trees, const FailedPlanning& failed, Space space, WhyNoPath& why) {
    const ClosestStates closest = closestStates(trees, *failed.definition->getSpaceInformation());
    std::vector<const ob::State*> way = trees.start.wayToRoot(closest.start);
    std::reverse(way.begin(), way.end());
    why.nearest.gap = way.size() - 1;
    for (const ob::State* state : trees.goal.wayToRoot(closest.goal)) way.push_back(state);
    for (const ob::State* state : way) why.nearest.path.push_back(fromOmpl(space, state));
    const ob::State *a = way[why.nearest.gap], *b = way[why.nearest.gap + 1];
    why.nearest.displacement =
        failed.validator->scene().part.displacement(failed.validator->pose(a), failed.validator->pose(b));
    why.isJoined = failed.validator->checkMotion(a, b);
}

std::vector<FollowedTrack> tracksOf(const FailedPlanning& failed) {
    constexpr double kSquare = 0.9;  // cosine
    const Scene& scene = failed.validator->scene();
    std::vector<FollowedTrack> tracks;
    for (const ob::PlannerPtr& planner : failed.planners) {
        const auto* team = dynamic_cast<const PlannerTeam*>(planner.get());
        const TwistSearch* search =
            team != nullptr ? team->twistSearch() : dynamic_cast<const TwistSearch*>(planner.get());
        if (search == nullptr) continue;
        for (const TwistTree::TrackEnd& end : search->ends()) {
            const MeshNames names = distinctMeshNames(scene, end.contact);
            tracks.push_back(end.isAtBounds ? FollowedTrack{"", "", false, end.length}
                                            : FollowedTrack{names.environment, names.part,
                                                            end.squareness > kSquare, end.length});
        }
    }
    return tracks;
}

/// The problem's goal. Nothing for a goal outside, and where the definition has a goal of the caller's elsewhere.
std::optional<ob::ScopedState<>> posedGoal(const Problem& problem, const ob::ProblemDefinition& definition) {
    if (problem.outside || !definition.getGoal()) return std::nullopt;
    const auto& space = definition.getSpaceInformation()->getStateSpace();
    ob::ScopedState<> state = toOmpl(space, problem.space, problem.goal);
    if (!definition.getGoal()->isSatisfied(state.get())) return std::nullopt;
    return state;
}

}  // namespace

std::string boundNamed(const BoxSide& side) {
    return std::string(side.isUpper ? "greatest " : "least ") + "xyz"[side.axis];
}

WhyNoPath whyNoPath(const FailedPlanning& failed, const Problem& problem,
                    const WhyNoPathOptions& options) try {
    WhyNoPath why;
    why.diagonal = failed.validator->scene().part.box().diagonal().norm();
    const std::optional<ob::ScopedState<>> goal = posedGoal(problem, *failed.definition);
    const FailedTrees trees = failedTrees(failed.planners, *failed.definition, *failed.validator,
                                          goal ? goal->get() : nullptr, options.isStopped);
    why.start = reachedFrom(trees.start, failed, problem, problem.start);
    if (goal) {
        why.goal = reachedFrom(trees.goal, failed, problem, problem.goal);
    } else {
        why.goal.states = trees.goal.states.size();  // from many poses: none to measure from
    }
    findNearestMiss(trees, failed, problem.space, why);
    why.tracks = tracksOf(failed);
    if (!why.isJoined) findBlockers(trees, *failed.validator, problem.space, options, why);
    return why;
} catch (const ompl::Exception& refusal) {
    throw OmplRefusal(refusal);
}

}  // namespace clearway::planning
