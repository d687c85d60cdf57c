#include <algorithm>
#include <limits>
#include <stdexcept>

#include "clearway/planning/clearance_objectives.h"
#include "planning/motion/motion_search.h"
#include "planning/objectives/objective_length.h"
#include "planning/objectives/objective_motions.h"

namespace clearway::planning {

namespace ob = ompl::base;

MinClearanceObjective::MinClearanceObjective(const ob::SpaceInformationPtr& si, Scene scene,
                                             const MinClearanceOptions& options)
    : ClearanceObjective(si, std::move(scene)) {
    setCap(options);
}

MinClearanceObjective::MinClearanceObjective(const ob::SpaceInformationPtr& si, Scene scene,
                                             StateToPose stateToPose, DisplacementBound bound,
                                             const MinClearanceOptions& options)
    : ClearanceObjective(si, std::move(scene), std::move(stateToPose), std::move(bound)) {
    setCap(options);
}

void MinClearanceObjective::setCap(const MinClearanceOptions& options) {
    description_ = "Least clearance";
    cap_ = std::min(lengthOr(options.cap, 1, scene().part, "cap"), motions_->mostClearance());
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

/// Poses of the reverse motion are off these by rounding and the jump at the end.
ob::Cost MinClearanceObjective::motionCost(const ob::State* s1, const ob::State* s2) const {
    const auto leastClearance = [&](Motion& motion) -> std::optional<double> {
        const double leastInterval = motions_->leastInterval();
        MotionSearch search(motion, leastInterval, leastInterval);
        const std::optional<double> least =
            search.leastClearance(cap_, usualResolution(scene(), leastInterval));
        if (!least) return least;
        return std::min(cap_, *least - motion.slack() - motion.endJump());
    };
    return ob::Cost(motions_->costOfMotion(s1, s2, -kInvalidMotionCost, leastClearance));
}

ob::Cost MinClearanceObjective::motionCostHeuristic(const ob::State*, const ob::State*) const {
    return ob::Cost(cap_);
}

}  // namespace clearway::planning
