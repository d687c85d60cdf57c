// Why planning found no path: how far the part comes from start and goal, what stops it, and the closest that the
// planners' trees came to each other.
#pragma once

#include <ompl/base/Planner.h>
#include <ompl/base/ProblemDefinition.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "clearway/planning/motion_validator.h"
#include "clearway/problem.h"

#pragma GCC visibility push(default)

namespace clearway::planning {

/// Planners that found no path.
struct FailedPlanning {
    std::vector<ompl::base::PlannerPtr> planners;  ///< with the trees they have grown
    /// With the problem's start; in its space. Its goal may be of any kind that the problem's goal satisfies, or a
    /// GoalSampleableRegion elsewhere.
    ompl::base::ProblemDefinitionPtr definition;
    std::shared_ptr<const MotionValidator>
        validator;  ///< decides which motions are valid, and what stops others
};

/// A part counts as shut in when no point of it has moved as far as this many diagonals of its box. A part that only
/// rotates on the spot moves by up to one diagonal.
constexpr double kShutIn = 1.5;

/// An obstacle or bound, and how many trial motions it blocked.
struct Blocker {
    std::string name;  ///< of the obstacle's component, see meshNames; empty for the bounds
    /// The part's component that it stopped most often; empty for the bounds, and for a part of one component.
    std::string partMesh;
    std::size_t atStart = 0;  ///< motions stopped, of those from states reached from the start
    std::size_t atGoal = 0;   ///< motions stopped, of those from states reached from the goal

    /// Whether the space's bounds are the hindrance, not an obstacle.
    bool isBounds() const { return name.empty(); }

    /// How many motions were stopped in all.
    std::size_t motions() const { return atStart + atGoal; }
};

/// Names a side of the bounds: "least x", "greatest z".
std::string boundNamed(const BoxSide& side);

/// How far the part comes from the start or the goal.
struct ReachedFrom {
    std::size_t states = 1;  ///< reached from there by valid motions, itself included
    bool hasTree = false;    ///< whether any planner grew a tree from this end
    /// The most that any point of the part moves from there to a state reached; see Model::displacement.
    double farthest = 0;
    std::size_t motionsStopped = 0;  ///< of the motions tried from these states
    /// The sides of the bounds that the part's origin is within a thousandth of the part's diagonal of.
    std::vector<BoxSide> bounds;
};

/// Where the states reached from the start and those reached from the goal are closest.
struct NearestMiss {
    /// From the start to the goal. All motions but the one from state `gap` to the next are in the planners' trees.
    std::vector<PartState> path;
    std::size_t gap = 0;      ///< index into `path` of the last state reached from the start
    double displacement = 0;  ///< the most that any point of the part moves over the gap
};

/// The end of a way that the planner for tight fits followed from the start as far as it went.
struct FollowedTrack {
    std::string
        obstacleMesh;      ///< of the closest pair there, see meshNames; empty where the bounds end the track
    std::string partMesh;  ///< the part's mesh of that pair
    bool isSquare =
        false;  ///< the contact's normal is within 25 degrees of the track: nothing beside it gives way
    double length =
        0;  ///< the way of the part's centre, and of a point a quarter of the diagonal from the axis of its turns
};

/// The answer of whyNoPath(). Lengths in environment units.
struct WhyNoPath {
    double diagonal = 0;  ///< of the part's box
    ReachedFrom start;    ///< how far the part comes from the start
    /// How far the part comes from the goal; only `states` is set for a goal outside, or if the definition has a goal
    /// of the caller's that problem.goal does not satisfy.
    ReachedFrom goal;
    std::size_t motionsTried = 0;       ///< how many motions were followed to find what stops the part
    std::vector<Blocker> blockers;      ///< those that stopped most motions first
    std::vector<FollowedTrack> tracks;  ///< of TwistSearch, where it took part
    NearestMiss nearest;                ///< where start and goal were nearly joined
    /// The motion over the gap is valid: the trees of several planners, joined, are a path.
    bool isJoined = false;

    /// True when no state was reached in which a point of the part has moved by as much as kShutIn.
    bool isShutIn(const ReachedFrom& end) const { return end.hasTree && end.farthest < kShutIn * diagonal; }
};

/// How long whyNoPath() tries.
struct WhyNoPathOptions {
    std::size_t motions = 400;        ///< how many are tried to find what stops the part
    std::optional<double> seconds;    ///< the trying ends after these; without them the answer is repeatable
    std::uint32_t seed = 1;           ///< of the random motions that are tried
    std::function<bool()> isStopped;  ///< true ends the trying
};

/// Examines the trees of the planners. To find what stops the part, it follows motions from random states of the
/// trees towards random poses until they are blocked. Positions of these poses are drawn from the bounds widened by a
/// quarter of the part's diagonal, so that the bounds can be what blocks.
///
/// Planners whose getPlannerData is empty (CForest) count as having grown no tree. Throws ArgumentError when
/// the definition has no start or no goal, or no state of the goal is known.
WhyNoPath whyNoPath(const FailedPlanning& failed, const Problem& problem,
                    const WhyNoPathOptions& options = {});

}  // namespace clearway::planning

#pragma GCC visibility pop
