#include <ompl/base/goals/GoalRegion.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "clearway/planning/clearance_objectives.h"
#include "core/number.h"
#include "planning/objectives/closeness_weight.h"
#include "planning/objectives/objective_length.h"
#include "planning/objectives/objective_motions.h"

namespace clearway::planning {
namespace {

namespace ob = ompl::base;

constexpr double kReferenceShare = 0.05;  ///< these are of the part's diagonal
constexpr double kFloorShare = 1e-3;
constexpr double kWantedShare = 0.05;

double requireResolution(double resolution) {
    if (resolution > 0 && resolution <= 1) return resolution;
    throw std::invalid_argument("resolution is " + shortNumber(resolution) +
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
    if (!(strictness >= 0) || !std::isfinite(strictness)) {
        throw std::invalid_argument("strictness is " + shortNumber(strictness) +
                                    ", expected a finite number >= 0");
    }
    const auto extra = [=](double clearance) { return strictness * std::max(0.0, 1 - clearance / wanted); };
    return {extra, wanted};
}

/// How far the goal is, where it is states, whose distance is the space's own.
ob::Cost lengthToGo(const ob::State* state, const ob::Goal* goal) {
    const bool isStates = goal->hasType(ob::GOAL_STATE) ||
                          (goal->hasType(ob::GOAL_STATES) && !goal->hasType(ob::GOAL_LAZY_SAMPLES));
    if (!isStates) return ob::Cost(0);
    const auto* region = goal->as<ob::GoalRegion>();
    return ob::Cost(std::max(0.0, region->distanceGoal(state) - region->getThreshold()));
}

}  // namespace

double wantedClearance(const LengthWithClearanceOptions& options, const Model& part) {
    return lengthOr(options.wanted, kWantedShare, part, "wanted clearance");
}

WeightedLengthObjective::WeightedLengthObjective(const ob::SpaceInformationPtr& si, Scene scene,
                                                 const ClosenessWeight& weight, double resolution)
    : ClearanceObjective(si, std::move(scene)),
      weight_(std::make_unique<ClosenessWeight>(weight)),
      resolution_(requireResolution(resolution)) {
    setCostToGoHeuristic(lengthToGo);
}

WeightedLengthObjective::WeightedLengthObjective(const ob::SpaceInformationPtr& si, Scene scene,
                                                 StateToPose stateToPose, DisplacementBound bound,
                                                 const ClosenessWeight& weight, double resolution)
    : ClearanceObjective(si, std::move(scene), std::move(stateToPose), std::move(bound)),
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

ClearanceIntegralObjective::ClearanceIntegralObjective(const ob::SpaceInformationPtr& si, const Scene& scene,
                                                       const ClearanceIntegralOptions& options)
    : WeightedLengthObjective(si, scene, weightOf(scene, options), options.resolution) {
    description_ = "Length weighted by closeness";
}

ClearanceIntegralObjective::ClearanceIntegralObjective(const ob::SpaceInformationPtr& si, const Scene& scene,
                                                       StateToPose stateToPose, DisplacementBound bound,
                                                       const ClearanceIntegralOptions& options)
    : WeightedLengthObjective(si, scene, std::move(stateToPose), std::move(bound), weightOf(scene, options),
                              options.resolution) {
    description_ = "Length weighted by closeness";
}

LengthWithClearanceObjective::LengthWithClearanceObjective(const ob::SpaceInformationPtr& si,
                                                           const Scene& scene,
                                                           const LengthWithClearanceOptions& options)
    : WeightedLengthObjective(si, scene, weightOf(scene, options), options.resolution) {
    description_ = "Length with a wanted clearance";
}

LengthWithClearanceObjective::LengthWithClearanceObjective(const ob::SpaceInformationPtr& si,
                                                           const Scene& scene, StateToPose stateToPose,
                                                           DisplacementBound bound,
                                                           const LengthWithClearanceOptions& options)
    : WeightedLengthObjective(si, scene, std::move(stateToPose), std::move(bound), weightOf(scene, options),
                              options.resolution) {
    description_ = "Length with a wanted clearance";
}

}  // namespace clearway::planning
