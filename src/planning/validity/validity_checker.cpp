#include "clearway/planning/validity_checker.h"

#include <ompl/util/Console.h>

#include <algorithm>
#include <exception>
#include <stdexcept>

#include "planning/validity/scene_clearance.h"
#include "planning/validity/space_of.h"

namespace clearway::planning {

namespace ob = ompl::base;

ValidityChecker::ValidityChecker(const ob::SpaceInformationPtr& si, Scene scene)
    : ValidityChecker(si, std::move(scene), planning::stateToPose(spaceOf(si))) {}

ValidityChecker::ValidityChecker(const ob::SpaceInformationPtr& si, Scene scene, StateToPose stateToPose)
    : StateValidityChecker(si),
      clearance_(std::make_shared<const SceneClearance>(std::move(scene))),
      stateToPose_(std::move(stateToPose)) {
    if (!stateToPose_) throw std::invalid_argument("stateToPose is empty, expected a function");
    specs_.clearanceComputationType = ob::StateValidityCheckerSpecs::BOUNDED_APPROXIMATE;
    specs_.hasValidDirectionComputation = false;
}

const Scene& ValidityChecker::scene() const {
    return clearance_->scene();
}

bool ValidityChecker::isValid(const ob::State* state) const {
    Pose X_environmentPart;
    const Usable usable = findPose(state, X_environmentPart);
    if (usable != Usable::kYes) return count(false, usable);
    try {
        return count(clearance_->isFree(X_environmentPart), usable);
    } catch (const std::exception& error) {
        reportUnusable(error.what());
        return count(false, Usable::kNoPose);
    }
}

bool ValidityChecker::isValid(const ob::State* state, double& clearance) const {
    Pose X_environmentPart;
    const Usable usable = findPose(state, X_environmentPart);
    clearance = 0;
    if (usable == Usable::kNoPose) return count(false, usable);
    if (usable == Usable::kOutOfBounds && clearance_->isOutOfReach(X_environmentPart)) {
        clearance = 0 - scene().largestMargin();  // of a distance that is at least 0
        return count(false, usable);
    }
    try {
        clearance = clearance_->at(X_environmentPart).lower;
    } catch (const std::exception& error) {
        reportUnusable(error.what());
        return count(false, Usable::kNoPose);
    }
    if (usable == Usable::kOutOfBounds) clearance = std::min(clearance, 0.0);
    return count(clearance > 0, usable);
}

bool ValidityChecker::isValid(const ob::State* state, double& clearance, ob::State* /*validState*/,
                              bool& validStateAvailable) const {
    validStateAvailable = false;
    return isValid(state, clearance);
}

double ValidityChecker::clearance(const ob::State* state) const {
    double result = 0;
    isValid(state, result);
    return result;
}

SceneDistance ValidityChecker::distance(const ob::State* state) const {
    return clearance_->distance(pose(state));
}

std::string ValidityChecker::whyInvalid(const ob::State* state) const {
    const std::string why = clearance_->whyInvalid(pose(state));
    if (!why.empty()) return why;
    return si_->satisfiesBounds(state) ? "" : "outside of the bounds of the state space";
}

CheckCounters ValidityChecker::counters() const {
    return {checks_.load(std::memory_order_relaxed), invalid_.load(std::memory_order_relaxed),
            outOfBounds_.load(std::memory_order_relaxed), unusable_.load(std::memory_order_relaxed)};
}

ValidityChecker::Usable ValidityChecker::findPose(const ob::State* state, Pose& X_environmentPart) const {
    try {
        X_environmentPart = stateToPose_(state);
    } catch (const std::exception& error) {
        reportUnusable(error.what());
        return Usable::kNoPose;
    }
    const double defect = rotationDefect(X_environmentPart);
    if (!(defect <= kPoseDefect)) {
        reportUnusable("the state has no pose: an entry is not finite or its rotation is none");
        return Usable::kNoPose;
    }
    return si_->satisfiesBounds(state) ? Usable::kYes : Usable::kOutOfBounds;
}

bool ValidityChecker::count(bool valid, Usable usable) const {
    checks_.fetch_add(1, std::memory_order_relaxed);
    if (!valid) invalid_.fetch_add(1, std::memory_order_relaxed);
    if (usable == Usable::kOutOfBounds) outOfBounds_.fetch_add(1, std::memory_order_relaxed);
    if (usable == Usable::kNoPose) unusable_.fetch_add(1, std::memory_order_relaxed);
    return valid;
}

void ValidityChecker::reportUnusable(const char* reason) const {
    if (!reportedUnusable_.exchange(true, std::memory_order_relaxed)) {
        OMPL_WARN("clearway: a state was answered invalid: %s. Further ones are only counted.", reason);
    }
}

}  // namespace clearway::planning
