#include "clearway/planning/clearance_objectives.h"

#include <ompl/base/goals/GoalRegion.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <vector>

#include "clearway/errors.h"
#include "clearway/planning/validity_checker.h"
#include "core/number.h"
#include "planning/check/motion_resolution.h"
#include "planning/check/motion_sweep.h"
#include "planning/check/posed_scene.h"
#include "planning/objectives/closeness_weight.h"
#include "planning/space/ompl_states.h"

namespace clearway::planning {
namespace {

/// An order of any two states that does not depend on which comes first.
bool isInOrder(const ob::StateSpace& space, const ob::State* a, const ob::State* b) {
    if (!space.hasSymmetricInterpolate()) return true;  // the two directions are two motions
    std::vector<unsigned char> ofA(space.getSerializationLength()), ofB(ofA.size());
    space.serialize(ofA.data(), a);
    space.serialize(ofB.data(), b);
    return ofA <= ofB;
}

/// Returns the given length, else a share of the diagonal of the part's box. Throws ArgumentError
/// that names the length unless it is finite and above 0.
double lengthOr(const std::optional<double>& given, double share, const Model& part,
                const std::string& name) {
    const double length = given ? *given : share * part.box().diagonal().norm();
    if (length > 0 && std::isfinite(length)) return length;
    throw ArgumentError(name + " is " + shortNumber(length) + ", expected a finite length above 0");
}

constexpr double kReferenceShare = 0.05;  ///< these are of the part's diagonal
constexpr double kFloorShare = 1e-3;
constexpr double kWantedShare = 0.05;

double requireResolution(double resolution) {
    if (resolution > 0 && resolution <= 1) return resolution;
    throw ArgumentError("resolution is " + shortNumber(resolution) +
                        ", expected a number above 0 and at most 1");
}

ClosenessWeight weightOf(const Scene& scene, const ClearanceIntegralOptions& options) {
    const double reference = lengthOr(options.reference, kReferenceShare, scene.part, "reference");
    const double floor = lengthOr(options.floor, kFloorShare, scene.part, "floor");
    const double cap = lengthOr(options.cap, 1, scene.part, "cap");
    const auto extra = [=](double clearance) {
        return std::max(0.0, reference / (clearance + floor) - reference / (cap + floor));
    };
    return {extra, cap};
}

ClosenessWeight weightOf(const Scene& scene, const LengthWithClearanceOptions& options) {
    const double wanted = wantedClearance(options, scene.part);
    const double strictness = options.strictness;
    requireNotNegative("strictness", strictness);
    const auto extra = [=](double clearance) { return strictness * std::max(0.0, 1 - clearance / wanted); };
    return {extra, wanted};
}

/// The length to a goal that consists of states, by the space's own distance. 0 for other goals.
ob::Cost lengthToGo(const ob::State* state, const ob::Goal* goal) {
    const bool isStates = goal->hasType(ob::GOAL_STATE) ||
                          (goal->hasType(ob::GOAL_STATES) && !goal->hasType(ob::GOAL_LAZY_SAMPLES));
    if (!isStates) return ob::Cost(0);
    const auto* region = goal->as<ob::GoalRegion>();
    return ob::Cost(std::max(0.0, region->distanceGoal(state) - region->getThreshold()));
}

}  // namespace

const SharedScene& sceneOf(const ob::SpaceInformationPtr& si) {
    spaceOf(si);
    const auto* checker = dynamic_cast<const ValidityChecker*>(si->getStateValidityChecker().get());
    if (checker != nullptr) return checker->shared();
    throw ArgumentError(
        "there is no scene: the space information's validity checker is none of clearway's, expected "
        "a clearway::planning::ValidityChecker to be set before");
}

/// Costs of states and motions in a scene. A motion and its reverse are looked at in one direction.
class ObjectiveMotions {
  public:
    /// Throws as ClearanceObjective's constructor does.
    ObjectiveMotions(const ob::SpaceInformationPtr& si, SharedScene scene)
        : posed_(si, std::move(scene), PosedScene::For::kMotions),
          leastInterval_(defaultLeastInterval(posed_.scene())) {
        if (mostClearance() > 0) return;
        throw ArgumentError("an obstacle was built with a range that ends " + shortNumber(mostClearance()) +
                            " beyond its margin, expected more than 0");
    }

    const Scene& scene() const { return posed_.scene(); }
    double mostClearance() const { return posed_.clearance().mostClearance(); }
    double leastInterval() const { return leastInterval_; }

    /// Returns cost(motion), or `otherwise` when that is nothing or throws. The motion has no warm start,
    /// which may change a distance's last digits, and goes in one direction, whichever state is the first.
    template <class CostOfMotion>
    double costOfMotion(const ob::State* s1, const ob::State* s2, double otherwise,
                        const CostOfMotion& cost) const {
        posed_.count(Count::kAsked);
        try {
            const SceneClearance::ColdStart cold(posed_.clearance());
            if (!isInOrder(posed_.space(), s1, s2)) std::swap(s1, s2);
            Motion motion(posed_, ClearanceDetail::kTight, 0, s1, s2);
            const std::optional<double> found = cost(motion);
            posed_.count(Count::kQueries, motion.queries());
            if (!found) posed_.count(Count::kInvalid);
            return found.value_or(otherwise);
        } catch (const std::exception& error) {
            return unusable(error.what(), otherwise);
        }
    }

    /// Returns cost(clearance) at a state, with clearances up to the cap, or `otherwise` when the state is
    /// invalid or has no pose.
    template <class CostOfClearance>
    double costOfState(const ob::State* state, double cap, double otherwise,
                       const CostOfClearance& cost) const {
        try {
            const std::optional<double> clearance = clearanceAt(state, cap);
            return clearance ? cost(*clearance) : otherwise;
        } catch (const std::exception& error) {
            return unusable(error.what(), otherwise);
        }
    }

    ObjectiveCounters counters() const {
        return {posed_.counted(Count::kAsked), posed_.counted(Count::kInvalid),
                posed_.counted(Count::kUnusable), posed_.counted(Count::kQueries)};
    }

  private:
    std::optional<double> clearanceAt(const ob::State* state, double cap) const {
        const Pose X_environmentPart = posed_.pose(state);
        requirePose(X_environmentPart);
        if (!posed_.si().satisfiesBounds(state)) return std::nullopt;
        ClearanceOptions options;
        options.cap = cap;
        const PoseClearance found = posed_.clearance().at(X_environmentPart, options);
        posed_.count(Count::kQueries, found.queries);
        if (!found.isValid()) return std::nullopt;
        return std::min(cap, found.lower);
    }

    double unusable(const char* reason, double cost) const {
        posed_.count(Count::kUnusable);
        posed_.warnOnce("an objective gave the worst cost", reason);
        return cost;
    }

    const PosedScene posed_;
    double leastInterval_;
};

ClearanceObjective::ClearanceObjective(const ob::SpaceInformationPtr& si, SharedScene scene)
    : OptimizationObjective(si), motions_(std::make_unique<ObjectiveMotions>(si, std::move(scene))) {}

ClearanceObjective::~ClearanceObjective() = default;

const Scene& ClearanceObjective::scene() const {
    return motions_->scene();
}

ObjectiveCounters ClearanceObjective::counters() const {
    return motions_->counters();
}

MinClearanceObjective::MinClearanceObjective(const ob::SpaceInformationPtr& si, SharedScene shared,
                                             const MinClearanceOptions& options)
    : ClearanceObjective(si, std::move(shared)), cap_(motions_->mostClearance()) {
    description_ = "Least clearance";
    if (options.cap) cap_ = std::min(cap_, lengthOr(options.cap, 1, scene().part, "cap"));
    setCostThreshold(ob::Cost(cap_));
    setCostToGoHeuristic([cap = cap_](const ob::State*, const ob::Goal*) { return ob::Cost(cap); });
}

bool MinClearanceObjective::isCostBetterThan(ob::Cost c1, ob::Cost c2) const {
    return c1.value() > c2.value();
}

ob::Cost MinClearanceObjective::combineCosts(ob::Cost c1, ob::Cost c2) const {
    return ob::Cost(std::min(c1.value(), c2.value()));
}

ob::Cost MinClearanceObjective::identityCost() const {
    return ob::Cost(std::numeric_limits<double>::infinity());
}

ob::Cost MinClearanceObjective::infiniteCost() const {
    return ob::Cost(-std::numeric_limits<double>::infinity());
}

bool MinClearanceObjective::isSatisfied(ob::Cost cost) const {
    return isCostBetterThan(cost, threshold_) || cost.value() >= cap_;
}

ob::Cost MinClearanceObjective::stateCost(const ob::State* state) const {
    return ob::Cost(
        motions_->costOfState(state, cap_, -kInvalidMotionCost, [](double clearance) { return clearance; }));
}

ob::Cost MinClearanceObjective::initialCost(const ob::State* state) const {
    return stateCost(state);
}

ob::Cost MinClearanceObjective::terminalCost(const ob::State* state) const {
    return stateCost(state);
}

ob::Cost MinClearanceObjective::motionCost(const ob::State* s1, const ob::State* s2) const {
    const auto leastClearance = [&](Motion& motion) -> std::optional<double> {
        const double leastInterval = motions_->leastInterval();
        const ClearanceResolution resolution = usualResolution(scene(), leastInterval);
        motion.measure();
        const std::optional<double> least =
            MotionSweep(motion, leastInterval, leastInterval).leastClearance(cap_, resolution, true);
        if (!least) return least;
        return std::min(cap_, *least);
    };
    return ob::Cost(motions_->costOfMotion(s1, s2, -kInvalidMotionCost, leastClearance));
}

ob::Cost MinClearanceObjective::motionCostHeuristic(const ob::State*, const ob::State*) const {
    return ob::Cost(cap_);
}

double wantedClearance(const LengthWithClearanceOptions& options, const Model& part) {
    return lengthOr(options.wanted, kWantedShare, part, "wanted clearance");
}

WeightedLengthObjective::WeightedLengthObjective(const ob::SpaceInformationPtr& si, const SharedScene& scene,
                                                 const ClosenessWeight& weight, double resolution)
    : ClearanceObjective(si, scene),
      weight_(std::make_unique<ClosenessWeight>(weight)),
      resolution_(requireResolution(resolution)) {
    setCostToGoHeuristic(lengthToGo);
}

WeightedLengthObjective::~WeightedLengthObjective() = default;

ob::Cost WeightedLengthObjective::stateCost(const ob::State* state) const {
    return ob::Cost(motions_->costOfState(state, weight_->end, kInvalidMotionCost,
                                          [&](double clearance) { return 1 + weight_->extra(clearance); }));
}

ob::Cost WeightedLengthObjective::motionCost(const ob::State* s1, const ob::State* s2) const {
    const auto weightedLength = [&](Motion& motion) -> std::optional<double> {
        const std::optional<double> mean =
            meanWeight(motion, *weight_, resolution_, motions_->leastInterval());
        if (!mean) return mean;
        return *mean * motion.distance();
    };
    return ob::Cost(motions_->costOfMotion(s1, s2, kInvalidMotionCost, weightedLength));
}

ob::Cost WeightedLengthObjective::motionCostHeuristic(const ob::State* s1, const ob::State* s2) const {
    return ob::Cost(si_->distance(s1, s2));
}

ClearanceIntegralObjective::ClearanceIntegralObjective(const ob::SpaceInformationPtr& si,
                                                       const SharedScene& scene,
                                                       const ClearanceIntegralOptions& options)
    : WeightedLengthObjective(si, scene, weightOf(scene.scene(), options), options.resolution) {
    description_ = "Length weighted by closeness";
}

LengthWithClearanceObjective::LengthWithClearanceObjective(const ob::SpaceInformationPtr& si,
                                                           const SharedScene& scene,
                                                           const LengthWithClearanceOptions& options)
    : WeightedLengthObjective(si, scene, weightOf(scene.scene(), options), options.resolution) {
    description_ = "Length with a wanted clearance";
}

}  // namespace clearway::planning
