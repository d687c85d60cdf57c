// Clearance objectives for OMPL's optimising planners, certified along whole motions.
#pragma once

#include <ompl/base/OptimizationObjective.h>
#include <ompl/base/SpaceInformation.h>

#include <cstdint>
#include <memory>
#include <optional>

#include "clearway/planning/shared_scene.h"
#include "clearway/scene.h"

#pragma GCC visibility push(default)

namespace clearway::planning {

class ObjectiveMotions;
struct ClosenessWeight;

/// The cost of an invalid motion or state, with the sign that makes it the worst. It is finite because graph
/// searches of OMPL take an infinite cost for a missing edge, where another validator has let the motion
/// pass.
constexpr double kInvalidMotionCost = 1e200;

/// Counts since the objective was made.
struct ObjectiveCounters {
    std::uint64_t motions = 0;   ///< whose cost was computed
    std::uint64_t invalid = 0;   ///< of these, with a pose that was found invalid
    std::uint64_t unusable = 0;  ///< states or motions without a pose or a bound, or whose callback threw
    std::uint64_t queries = 0;   ///< of distances
};

/// The base of the objectives here. The clearance is the least distance - margin over the obstacles that
/// count at a pose; a range limits it (see ValidityChecker::clearance). Objectives may be used before
/// si->setup().
///
/// Where OMPL interpolates the same way in both directions, as in SE(3) and SE(2), a motion and its reverse
/// cost exactly the same, because both are looked at in one direction. (In a space without OMPL's
/// serialisation the two costs agree to rounding.) The cost holds for either direction.
///
/// Any number of threads may use one objective: each has its own scratch and takes no lock. Objectives throw
/// nothing out of OMPL's callbacks: a state or motion that cannot be judged costs kInvalidMotionCost and is
/// counted, and the first one is logged through OMPL's console.
class ClearanceObjective : public ompl::base::OptimizationObjective {
  public:
    ~ClearanceObjective() override;

    /// The scene that clearances are measured in.
    const Scene& scene() const;

    /// Counts of all threads' work for this objective.
    ObjectiveCounters counters() const;

  protected:
    /// A Scene, or a SharedScene that others share. Throws ArgumentError when si is null or has another space than
    /// OMPL's SE(3) and SE(2) and the scene no callbacks for it (see displacementBound), a margin is negative or not finite,
    /// the part and an obstacle cannot be queried together, or the environment was built with a range that is not longer
    /// than the margin.
    ClearanceObjective(const ompl::base::SpaceInformationPtr& si, SharedScene scene);

    std::unique_ptr<const ObjectiveMotions> motions_;  ///< finds clearances of states and motions; never null
};

/// Returns the scene of si's validity checker, to be shared. Throws ArgumentError when si is null or its checker is
/// none of clearway's.
const SharedScene& sceneOf(const ompl::base::SpaceInformationPtr& si);

/// The option of MinClearanceObjective.
struct MinClearanceOptions {
    /// Clearances above the cap count as the cap. Environment units, finite, > 0. Without a cap only the
    /// environment's range limits clearances. No path has more clearance than its start or its goal, so the smaller
    /// of these two is a good cap.
    std::optional<double> cap;
};

/// Maximises the least clearance along the whole path, both ends included. Costs are clearances, in
/// environment units: larger is better, and a path costs as much as its worst motion.
///
/// A motion's cost is certified: no pose of it has less clearance. Some pose exceeds the cost by no more than
/// 1 % or, where that is more, 1e-3 of the part's diagonal, but then by no more than 10 % or 1e-5 of the
/// diagonal. (The cost is also lowered by the distance from the end of OMPL's interpolation to the motion's
/// end, because OMPL may leave out rotations of up to 1.6e-4 rad.) A cost of at most 0 means that the motion is not
/// certified to be valid.
class MinClearanceObjective : public ClearanceObjective {
  public:
    /// Throws as ClearanceObjective does, and when the cap is not finite and above 0.
    MinClearanceObjective(const ompl::base::SpaceInformationPtr& si, SharedScene scene,
                          const MinClearanceOptions& options = {});

    /// Whether c1 is larger: costs compare and combine as in OMPL's MaximizeMinClearanceObjective.
    bool isCostBetterThan(ompl::base::Cost c1, ompl::base::Cost c2) const override;

    /// The smaller one of two costs.
    ompl::base::Cost combineCosts(ompl::base::Cost c1, ompl::base::Cost c2) const override;
    ompl::base::Cost identityCost() const override;  ///< infinity
    ompl::base::Cost infiniteCost() const override;  ///< -infinity

    /// True for costs better than the threshold, and for the cap, because no cost is better. The threshold is
    /// the cap unless it is set: planners then go on until their time is up.
    bool isSatisfied(ompl::base::Cost cost) const override;

    /// A lower bound of the clearance at a state, but at most the cap; -kInvalidMotionCost for an invalid
    /// or unusable state.
    ompl::base::Cost stateCost(const ompl::base::State* state) const override;
    ompl::base::Cost initialCost(const ompl::base::State* state) const override;   ///< stateCost
    ompl::base::Cost terminalCost(const ompl::base::State* state) const override;  ///< stateCost

    /// The certified least clearance along a motion, see the class; at most the cap.
    ompl::base::Cost motionCost(const ompl::base::State* s1, const ompl::base::State* s2) const override;

    /// The cap, because no motion is better. The heuristic of the cost to go is the cap too.
    ompl::base::Cost motionCostHeuristic(const ompl::base::State* s1,
                                         const ompl::base::State* s2) const override;

    /// The clearance from which on all clearances count alike; environment units. It is the option's value, or the largest
    /// clearance that the environment's range lets queries tell, if that is less; infinite without either.
    double cap() const { return cap_; }

  private:
    double cap_;
};

/// Minimises length, weighted by how close the part is. Length is si->distance: in SE(3) and SE(2) that of
/// the translation plus that of the rotation times its subspace weight. At every pose length counts 1 + extra
/// times, where extra >= 0 depends on the clearance there. So length is an admissible heuristic for the cost,
/// and for the cost to go when the goal consists of states.
///
/// Where a contact zone ignores obstacles, the clearance is how far the part may move before they count, if
/// that is more than the clearance they leave.
///
/// A motion is divided only where the clearances known so far leave its cost less sure than the resolution.
/// Poses within 1e-5 of the part's diagonal of contact may be taken for valid: the motion validator decides
/// what is valid.
class WeightedLengthObjective : public ClearanceObjective {
  public:
    ~WeightedLengthObjective() override;

    /// 1 + extra at a state; kInvalidMotionCost for an invalid or unusable state.
    ompl::base::Cost stateCost(const ompl::base::State* state) const override;

    /// The weighted length of a motion, to the resolution; kInvalidMotionCost for an invalid motion.
    ompl::base::Cost motionCost(const ompl::base::State* s1, const ompl::base::State* s2) const override;

    /// The length of a motion: no motion between the two states costs less.
    ompl::base::Cost motionCostHeuristic(const ompl::base::State* s1,
                                         const ompl::base::State* s2) const override;

  protected:
    /// Throws as ClearanceObjective does, and when the resolution is not above 0 and at most 1.
    WeightedLengthObjective(const ompl::base::SpaceInformationPtr& si, const SharedScene& scene,
                            const ClosenessWeight& weight, double resolution);

  private:
    std::unique_ptr<const ClosenessWeight> weight_;
    double resolution_;
};

/// The options of ClearanceIntegralObjective. Lengths in environment units, finite, > 0. Each default is a
/// share of the diagonal of the part's box.
struct ClearanceIntegralOptions {
    std::optional<double> reference;  ///< the clearance at which length counts about twice; 5 %
    std::optional<double> floor;      ///< keeps the weight of contact finite; 0.1 %
    std::optional<double> cap;        ///< from this clearance on length counts once; 100 %
    double resolution = 0.1;          ///< the largest error of a cost, as a share of it; > 0, at most 1
};

/// Minimises the length weighted by closeness: extra(c) = reference / (c + floor) - reference / (cap + floor)
/// at clearances c < cap.
class ClearanceIntegralObjective : public WeightedLengthObjective {
  public:
    /// Throws as WeightedLengthObjective does, and when an option is wrong.
    ClearanceIntegralObjective(const ompl::base::SpaceInformationPtr& si, const SharedScene& scene,
                               const ClearanceIntegralOptions& options = {});
};

/// The options of LengthWithClearanceObjective.
struct LengthWithClearanceOptions {
    /// The clearance to keep. Environment units, finite, > 0. The default is 5 % of the diagonal of the
    /// part's box.
    std::optional<double> wanted;
    double strictness = 10;   ///< by how many lengths more a length in contact counts; >= 0, finite
    double resolution = 0.1;  ///< the largest error of a cost, as a share of it; > 0, at most 1
};

/// Returns options.wanted or its default. Throws ArgumentError unless the length is finite and above
/// 0.
double wantedClearance(const LengthWithClearanceOptions& options, const Model& part);

/// Minimises the length of paths that keep a wanted clearance where they can: extra(c) = strictness
/// (1 - c / wanted) at clearances c < wanted. So a detour of up to 1 + strictness times the length is worth
/// while to avoid contact.
class LengthWithClearanceObjective : public WeightedLengthObjective {
  public:
    /// Throws as WeightedLengthObjective does, and when an option is wrong.
    LengthWithClearanceObjective(const ompl::base::SpaceInformationPtr& si, const SharedScene& scene,
                                 const LengthWithClearanceOptions& options = {});
};

}  // namespace clearway::planning

#pragma GCC visibility pop
