// What planners of OMPL that optimise can be asked for beside short paths: clearance, certified along whole
// motions.
#pragma once

#include <ompl/base/OptimizationObjective.h>
#include <ompl/base/SpaceInformation.h>

#include <cstdint>
#include <memory>
#include <optional>

#include "clearway/planning/displacement_bound.h"
#include "clearway/planning/state_to_pose.h"
#include "clearway/scene.h"

namespace clearway::planning {

class ObjectiveMotions;
struct ClosenessWeight;

/// What a motion or state that is invalid costs, with the sign that makes it the worst. Finite: where
/// another validator has let it pass, graph searches of OMPL would take an infinite cost for a missing edge.
constexpr double kInvalidMotionCost = 1e200;

/// What an objective has been asked since it was made.
struct ObjectiveCounters {
    std::uint64_t motions = 0;   ///< whose cost was asked for
    std::uint64_t invalid = 0;   ///< of these: a pose was found invalid
    std::uint64_t unusable = 0;  ///< states or motions without a pose or a bound, or whose callback threw
    std::uint64_t queries = 0;   ///< of distances
};

/// What the objectives here have in common. The clearance is the least distance less margin of the obstacles
/// that count at a pose; a reach bounds it (see ValidityChecker::clearance). They may be used before
/// si->setup().
///
/// Where OMPL interpolates the same way in both directions, as in SE(3) and SE(2), a motion and its reverse
/// cost exactly the same, for both are looked at in one direction. (A space without OMPL's serialisation
/// gives both directions to rounding.) The cost holds for either.
///
/// Any number of threads may use one objective: each has its own scratch and takes no lock. Nothing is thrown
/// out of OMPL's callbacks: what cannot be judged costs kInvalidMotionCost, is counted, and logged once
/// through OMPL's console.
class ClearanceObjective : public ompl::base::OptimizationObjective {
  public:
    ~ClearanceObjective() override;

    const Scene& scene() const;
    ObjectiveCounters counters() const;

  protected:
    /// For OMPL's SE(3) and SE(2). Throws std::invalid_argument when si is null or has another space (see
    /// displacementBound), the margin is negative or not finite, the two models cannot be queried together,
    /// or the environment was built with a reach that ends before the margin.
    ClearanceObjective(const ompl::base::SpaceInformationPtr& si, Scene scene);

    /// For any space. Throws likewise, and when a callback is empty. See MotionValidator for what poses of
    /// interpolated states must be.
    ClearanceObjective(const ompl::base::SpaceInformationPtr& si, Scene scene, StateToPose stateToPose,
                       DisplacementBound bound);

    std::unique_ptr<const ObjectiveMotions> motions_;
};

/// The scene of the validity checker that si has. Throws std::invalid_argument when si is null or its checker
/// is none of clearway's.
const Scene& sceneOf(const ompl::base::SpaceInformationPtr& si);

struct MinClearanceOptions {
    /// More clearance is as good as this. Environment units, finite, > 0. The default is the diagonal of the
    /// part's box.
    std::optional<double> cap;
};

/// Maximises the least clearance along the whole path, both ends included. Costs are clearances, in
/// environment units: larger is better, the cost of a path is that of its worst motion.
///
/// A motion's cost is certified: no pose of it has less clearance, and some pose has no more than 1 % on top
/// or, where that is more, 1e-3 of the part's diagonal, but then no more than 10 % or 1e-5 of the diagonal.
/// (Also counted off: how far the end of OMPL's interpolation is off the motion's end, where it leaves out
/// rotations below 1.6e-4 rad.) At most 0: the motion is not certified to be valid.
class MinClearanceObjective : public ClearanceObjective {
  public:
    /// Throws as ClearanceObjective does, and when an option is wrong.
    MinClearanceObjective(const ompl::base::SpaceInformationPtr& si, Scene scene,
                          const MinClearanceOptions& options = {});
    MinClearanceObjective(const ompl::base::SpaceInformationPtr& si, Scene scene, StateToPose stateToPose,
                          DisplacementBound bound, const MinClearanceOptions& options = {});

    /// As of OMPL's MaximizeMinClearanceObjective: larger is better, of two costs the worse counts.
    bool isCostBetterThan(ompl::base::Cost c1, ompl::base::Cost c2) const override;
    ompl::base::Cost combineCosts(ompl::base::Cost c1, ompl::base::Cost c2) const override;
    ompl::base::Cost identityCost() const override;  ///< infinity
    ompl::base::Cost infiniteCost() const override;  ///< -infinity

    /// Better than the threshold, or the cap, which nothing is better than. The threshold is the cap unless
    /// it is set: planners then go on until their time is up.
    bool isSatisfied(ompl::base::Cost cost) const override;

    ompl::base::Cost stateCost(const ompl::base::State* state) const override;
    ompl::base::Cost initialCost(const ompl::base::State* state) const override;   ///< stateCost
    ompl::base::Cost terminalCost(const ompl::base::State* state) const override;  ///< stateCost
    ompl::base::Cost motionCost(const ompl::base::State* s1, const ompl::base::State* s2) const override;

    /// The cap: no motion is better. So is the cost to go.
    ompl::base::Cost motionCostHeuristic(const ompl::base::State* s1,
                                         const ompl::base::State* s2) const override;

    double cap() const { return cap_; }

  private:
    void setCap(const MinClearanceOptions& options);
    double cap_ = 0;
};

/// Lengths, weighted by how close the part is. Length is si->distance: in SE(3) and SE(2) that of the
/// translation plus that of the rotation times its subspace weight. At every pose it counts 1 + extra times,
/// extra >= 0 depending on the clearance there, so that length is an admissible heuristic for the cost, and
/// for the cost to go when the goal is a state or several.
///
/// Where a contact zone ignores obstacles, the clearance is how far the part may move until they count, if
/// that is more than they leave.
///
/// A motion is divided where what is certain of the clearance between the poses looked at leaves its cost
/// less sure than the resolution, and nowhere else. Poses within 1e-5 of the part's diagonal of contact may
/// be taken for valid: the motion validator says what is.
class WeightedLengthObjective : public ClearanceObjective {
  public:
    ~WeightedLengthObjective() override;

    ompl::base::Cost stateCost(const ompl::base::State* state) const override;  ///< 1 + extra
    ompl::base::Cost motionCost(const ompl::base::State* s1, const ompl::base::State* s2) const override;
    ompl::base::Cost motionCostHeuristic(const ompl::base::State* s1,
                                         const ompl::base::State* s2) const override;

  protected:
    /// Throws as ClearanceObjective does, and when the resolution is not above 0 and at most 1.
    WeightedLengthObjective(const ompl::base::SpaceInformationPtr& si, Scene scene,
                            const ClosenessWeight& weight, double resolution);
    WeightedLengthObjective(const ompl::base::SpaceInformationPtr& si, Scene scene, StateToPose stateToPose,
                            DisplacementBound bound, const ClosenessWeight& weight, double resolution);

  private:
    std::unique_ptr<const ClosenessWeight> weight_;
    double resolution_;
};

struct ClearanceIntegralOptions {
    /// Lengths in environment units, finite, > 0. Each default is a share of the diagonal of the part's box.
    std::optional<double> reference;  ///< the clearance at which length counts about twice; 5 %
    std::optional<double> floor;      ///< what keeps the weight of contact finite; 0.1 %
    std::optional<double> cap;        ///< from here on length counts once; 100 %
    double resolution = 0.1;          ///< a cost is off by at most this share of it; > 0, at most 1
};

/// Minimises the length weighted by closeness: extra(c) = reference / (c + floor) - reference / (cap + floor)
/// at clearances c < cap.
class ClearanceIntegralObjective : public WeightedLengthObjective {
  public:
    /// Throws as WeightedLengthObjective does, and when an option is wrong.
    ClearanceIntegralObjective(const ompl::base::SpaceInformationPtr& si, const Scene& scene,
                               const ClearanceIntegralOptions& options = {});
    ClearanceIntegralObjective(const ompl::base::SpaceInformationPtr& si, const Scene& scene,
                               StateToPose stateToPose, DisplacementBound bound,
                               const ClearanceIntegralOptions& options = {});
};

struct LengthWithClearanceOptions {
    /// The clearance to keep. Environment units, finite, > 0. The default is 5 % of the diagonal of the
    /// part's box.
    std::optional<double> wanted;
    double strictness = 10;   ///< >= 0, finite
    double resolution = 0.1;  ///< a cost is off by at most this share of it; > 0, at most 1
};

/// Minimises the length of paths that keep a wanted clearance where they can: extra(c) = strictness
/// (1 - c / wanted) at clearances c < wanted. So a way past contact is worth up to 1 + strictness times its
/// length to go round.
class LengthWithClearanceObjective : public WeightedLengthObjective {
  public:
    /// Throws as WeightedLengthObjective does, and when an option is wrong.
    LengthWithClearanceObjective(const ompl::base::SpaceInformationPtr& si, const Scene& scene,
                                 const LengthWithClearanceOptions& options = {});
    LengthWithClearanceObjective(const ompl::base::SpaceInformationPtr& si, const Scene& scene,
                                 StateToPose stateToPose, DisplacementBound bound,
                                 const LengthWithClearanceOptions& options = {});
};

}  // namespace clearway::planning
