// A tree of screw motions that leads a part out of a tight fit.
#pragma once

#include <ompl/base/PlannerData.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/goals/GoalRegion.h>
#include <ompl/util/RandomNumbers.h>

#include <memory>
#include <optional>
#include <vector>

#include "clearway/planning/motion_validator.h"
#include "clearway/scene_clearance.h"
#include "planning/improve/contact_planes.h"
#include "planning/improve/screw.h"

namespace clearway::planning {

/// Grows from roots in tight fits along screws that the contacts nearby leave open, each followed as far as OMPL's motions along it are valid. Works in
/// small steps, so that planners can take turns.
class TwistTree {
  public:
    /// goal: ends the search where it is satisfied, and is tried for first; null: the tree grows until the part has come free.
    /// isFromStart: otherwise paths take the tree's motions in reverse. The other arguments must outlive this object.
    TwistTree(ompl::base::SpaceInformationPtr si, const SceneClearance& clearance, const PartMoves& moves,
              const ompl::base::GoalRegion* goal, bool isFromStart);
    ~TwistTree();
    TwistTree(const TwistTree&) = delete;
    TwistTree& operator=(const TwistTree&) = delete;

    struct Node {
        ompl::base::State* state;
        Pose X_environmentPart;
        Node* parent;
        Screw screw;        ///< from the parent, for a unit of time
        std::size_t index;  ///< among all nodes
        int depth;          ///< tracks from the root
        double toGoal;      ///< the goal's distance; 0 without a goal
        double length;      ///< of the way from the parent
        double play;        ///< the gap that a centred part has there
        double clearance;   ///< the part has at least this there
        bool isWhole;       ///< the screw from the parent was followed as far as wanted
        std::vector<ompl::base::State*>
            states;  ///< between the parent and this one; OMPL's motions between them are valid
    };

    void addRoot(const ompl::base::State* state);
    std::size_t rootCount() const { return rootCount_; }

    /// Takes one step: a look around, a try of a direction, or a piece of a track. Returns whether there is anything left to do.
    bool work();

    /// A node where the goal is satisfied; null before there is one.
    const Node* atGoal() const { return atGoal_; }
    /// The nodes where the part has come free: it has more play than a tight fit leaves.
    const std::vector<const Node*>& free() const { return free_; }
    const ompl::base::State* stateOf(const Node& node) const { return node.state; }

    /// The states from a root to the node, between which OMPL's motions are valid in the direction of the tree's paths.
    std::vector<const ompl::base::State*> pathTo(const Node& node) const;

    /// Adds the tree's states and motions, in the direction of paths.
    void addData(ompl::base::PlannerData& data) const;

    /// The end of a track that was given up.
    struct TrackEnd {
        SceneDistance contact;  ///< the closest pair there
        double squareness;  ///< cosine of the angle between the track and the contact's normal; 1: head on
        double length;      ///< of the track, as twists measure it
        bool isAtBounds;    ///< the bounds end the track, not the contact
    };
    const std::vector<TrackEnd>& ends() const { return ends_; }

    /// Whether a fit is tight: a part with more clearance than that is better served by other planners.
    static bool isTight(const SceneClearance& clearance, const PartMoves& moves,
                        const Pose& X_environmentPart);

  private:
    static constexpr double kFreeGap = 0.05;    ///< of half the diagonal of the part's box
    static constexpr double kBackOff = 0.8;     ///< of what is free ahead of a block
    static constexpr double kWayBack = 0.9;     ///< cosine with the way back, which is not tried
    static constexpr double kDepthLoss = 0.8;   ///< of a score, for each track from the root
    static constexpr double kAdvancing = 1e-3;  ///< of a turn: screws that advance less are turns

    struct Advance {
        double time = 0;  ///< how far the screw is free at the poses that were looked at
        bool isWhole = false;
    };
    struct Candidate {
        Node* node;
        Screw screw;             ///< moves the part by a twist of length 1 in a unit of time
        double score = 0;        ///< the share of the part's radius that is free
        double length = 0;       ///< length to begin with
        bool isInwards = false;  ///< the goal comes no nearer
        bool isReverse = false;  ///< reverses a direction that was tried
    };

    /// A screw that is being followed.
    struct Track {
        Node* node;
        Screw screw;
        double step;
        std::size_t first;  ///< how many nodes there were before it
        double length = 0, sinceBlock = 0;
        double pulledAt = 0;  ///< the clearance where a pull was tried last
        int shortAdvances = 0;
        std::optional<Advance> known{};  ///< of the next step
        std::vector<Node*> nodes{};
    };

    /// The places along a track where directions of other tracks are tried.
    struct Probe {
        std::vector<Node*> nodes;
        double length;
        int count, next = 0, found = 0;
        double priority;
    };

    double floorFrom(const Node& node) const;
    Advance advance(const Node& from, const Screw& screw) const;
    Node* grow(Node* parent, const Screw& screw, double time);
    void lookAround(Node& node, const Twist* arrived);
    void score(const Candidate& candidate);
    bool leadsNearer(const Candidate& candidate) const;
    double priorityOf(const Candidate& candidate) const;
    void begin(const Candidate& candidate);
    void followOn();
    static Vector3 headingOf(const Screw& screw, const Vector3& point);
    void reachGoal(const Node* node);
    bool pullOut(Node& node, const Screw& screw);
    void finishTrack();
    Node* centre(Node* node, const Twist& along);
    Screw chooseScrew(const Node& node, double wanted);
    bool isOld(const ompl::base::State* state, std::size_t count) const;
    void findClearance(Node& node) const;
    void probe();
    double band() const;
    double resolution() const;
    std::size_t countBehind(const Node& node) const;
    Twist twistOf(const Screw& screw, const Node& node) const;
    Screw screwOf(const Twist& twist, const Node& node) const;
    double goalDistance(const Node& node) const {
        return goal_ != nullptr ? goal_->distanceGoal(node.state) : 0;
    }

    bool isValidMotion(const ompl::base::State* from, const ompl::base::State* to, double floor) const;

    ompl::base::SpaceInformationPtr si_;
    const SceneClearance& clearance_;
    const PartMoves& moves_;
    const ompl::base::GoalRegion* goal_;
    const bool isFromStart_;
    const MotionValidator* validator_;  ///< null for one that is not clearway's
    const Matrix3 principalAxes_;       ///< in the part's coordinates
    double play_ = 0;                   ///< of the node that is at work
    double rootPlay_ = 0;               ///< the largest of the roots'
    ompl::RNG random_;
    std::vector<std::unique_ptr<Node>> nodes_;
    std::vector<Candidate> unscored_, late_, open_;
    std::unique_ptr<Track> track_;
    std::vector<Probe> probes_;
    std::vector<Screw> library_;  ///< of tracks, at any scale
    std::vector<TrackEnd> ends_;
    std::vector<const Node*> free_;
    const Node* atGoal_ = nullptr;
    std::size_t rootCount_ = 0;
};

}  // namespace clearway::planning
