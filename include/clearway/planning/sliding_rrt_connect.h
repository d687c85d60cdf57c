// A planner for narrow passages: RRT-Connect whose trees slide along what blocks them.
#pragma once

#include <ompl/base/Planner.h>
#include <ompl/datastructures/NearestNeighbors.h>
#include <ompl/util/RandomNumbers.h>

#include <limits>
#include <memory>
#include <vector>

#pragma GCC visibility push(default)

namespace clearway::planning {

/// Grows one tree from the start and one from the goal, as RRT-Connect does (Kuffner and LaValle, RRT-Connect: An
/// Efficient Approach to Single-Query Path Planning, ICRA 2000). Where an extension is blocked, a distance query names
/// the closest points, and the part moves on along the plane between them, a standoff away, up to several planes at a
/// time. So extensions follow walls into passages that hardly any sample lies in. Retraction to contact is the idea of
/// Zhang and Manocha (An Efficient Retraction-based RRT Planner, ICRA 2008); nodes that lead nowhere are left out by
/// dynamic domains (Yershova, Jaillet, Simeon, LaValle, Dynamic-Domain RRTs, ICRA 2005).
///
/// The scene is that of the space information's validity checker, which must be one of clearway's; the space is
/// OMPL's SE(3) or SE(2). All motions of a path were checked by the space information's motion validator, in the
/// direction in which the path takes them.
///
/// The range of standoffs decides which passages are found: a standoff must fit into a passage on both sides of the
/// part, and small standoffs make for small steps. Two planners with different ranges, in parallel, find more than
/// one with both.
class SlidingRRTConnect : public ompl::base::Planner {
  public:
    /// Makes a planner without trees. si: its scene and space are looked at by setup().
    explicit SlidingRRTConnect(const ompl::base::SpaceInformationPtr& si);
    ~SlidingRRTConnect() override;

    /// Measures the part. Throws ArgumentError when the space or the validity checker is not as
    /// above.
    void setup() override;

    /// Plans until there is an exact solution or isSpent is true. Goes on from the trees of a former call.
    ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition& isSpent) override;

    /// Forgets all trees.
    void clear() override;

    /// Adds the states and edges of both trees to `data`, as OMPL's planners do.
    void getPlannerData(ompl::base::PlannerData& data) const override;

    /// Sets the longest extension towards a sample, in environment units; 0: a quarter of the diagonal of the part's
    /// box. The length of an extension is the distance that the centre of the part's box moves plus its rotation
    /// times a quarter of the diagonal.
    void setRange(double range) { range_ = range; }
    /// The value that setRange was given; 0 at first.
    double getRange() const { return range_; }

    /// Sets the least standoff, in environment units; 0: 0.0025 of the diagonal of the part's box. Each
    /// extension draws its standoff, the gap that slides keep, between the least and the most one, evenly by
    /// its logarithm.
    void setLeastStandoff(double standoff) { leastStandoff_ = standoff; }
    /// The value that setLeastStandoff was given; 0 at first.
    double getLeastStandoff() const { return leastStandoff_; }

    /// Sets the most standoff, in environment units; 0: 0.05 of the diagonal of the part's box.
    void setMostStandoff(double standoff) { mostStandoff_ = standoff; }
    /// The value that setMostStandoff was given; 0 at first.
    double getMostStandoff() const { return mostStandoff_; }

  protected:
    /// Draws the states that trees extend towards, uniformly; null: solve() allocates the space's own sampler.
    ompl::base::StateSamplerPtr sampler_;

  private:
    struct Node;
    struct Tree;
    struct Lengths;
    class Extension;

    void addRoot(Tree& tree, const ompl::base::State* state) const;
    Node* addPoint(Tree& tree, Node* parent, const ompl::base::State* state) const;
    Tree& treeOf(bool isFromStart) const { return isFromStart ? *start_ : *goal_; }
    Node* extend(Tree& tree, Node* from, const ompl::base::State* target, double reach, bool& isReached);
    void addSolution(const Node* inStart, const Node* inGoal, bool isExact);
    bool addGoals(const ompl::base::PlannerTerminationCondition& isSpent);

    double range_ = 0, leastStandoff_ = 0, mostStandoff_ = 0;
    std::unique_ptr<Lengths> lengths_;
    std::unique_ptr<Tree> start_, goal_;
    ompl::RNG random_;
    bool isStartNext_ = true;
};

}  // namespace clearway::planning

#pragma GCC visibility pop
