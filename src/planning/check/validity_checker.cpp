#include "clearway/planning/validity_checker.h"

#include <algorithm>
#include <exception>

#include "planning/check/posed_scene.h"
#include "planning/space/ompl_states.h"

namespace clearway::planning {

ValidityChecker::ValidityChecker(const ob::SpaceInformationPtr& si, SharedScene scene)
    : StateValidityChecker(si),
      posed_(std::make_shared<const PosedScene>(si, std::move(scene), PosedScene::For::kStates)) {
    specs_.clearanceComputationType = ob::StateValidityCheckerSpecs::BOUNDED_APPROXIMATE;
    specs_.hasValidDirectionComputation = false;
}

const Scene& ValidityChecker::scene() const {
    return posed_->scene();
}

const SharedScene& ValidityChecker::shared() const {
    return posed_->shared();
}

Pose ValidityChecker::pose(const ob::State* state) const {
    return posed_->pose(state);
}

bool ValidityChecker::isValid(const ob::State* state) const {
    Pose X_environmentPart;
    const Usable usable = findPose(state, X_environmentPart);
    if (usable != Usable::kYes) return count(false, usable);
    try {
        return count(posed_->clearance().isFree(X_environmentPart), usable);
    } catch (const std::exception& error) {
        return unusable(error.what());
    }
}

bool ValidityChecker::isValid(const ob::State* state, double& clearance) const {
    Pose X_environmentPart;
    const Usable usable = findPose(state, X_environmentPart);
    clearance = 0;
    if (usable == Usable::kNoPose) return count(false, usable);
    if (usable == Usable::kOutOfBounds && posed_->clearance().isOutOfRange(X_environmentPart)) {
        clearance = 0 - scene().largestMargin();  // because a distance is at least 0
        return count(false, usable);
    }
    try {
        clearance = posed_->clearance().at(X_environmentPart).lower;
    } catch (const std::exception& error) {
        return unusable(error.what());
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
    return posed_->clearance().distance(pose(state));
}

WhyInvalid ValidityChecker::whyInvalid(const ob::State* state) const {
    return posed_->whyInvalid(state);
}

CheckCounters ValidityChecker::counters() const {
    return {posed_->counted(Count::kAsked), posed_->counted(Count::kInvalid),
            posed_->counted(Count::kOutOfBounds), posed_->counted(Count::kUnusable)};
}

ValidityChecker::Usable ValidityChecker::findPose(const ob::State* state, Pose& X_environmentPart) const {
    try {
        X_environmentPart = posed_->pose(state);
    } catch (const std::exception& error) {
        warn(error.what());
        return Usable::kNoPose;
    }
    const double defect = rotationDefect(X_environmentPart);
    if (!(defect <= kPoseDefect)) {
        warn("the state has no pose: an entry is not finite or its matrix is no rotation");
        return Usable::kNoPose;
    }
    return si_->satisfiesBounds(state) ? Usable::kYes : Usable::kOutOfBounds;
}

bool ValidityChecker::count(bool valid, Usable usable) const {
    posed_->count(Count::kAsked);
    if (!valid) posed_->count(Count::kInvalid);
    if (usable == Usable::kOutOfBounds) posed_->count(Count::kOutOfBounds);
    if (usable == Usable::kNoPose) posed_->count(Count::kUnusable);
    return valid;
}

void ValidityChecker::warn(const char* reason) const {
    posed_->warnOnce("a state was answered invalid", reason);
}

bool ValidityChecker::unusable(const char* reason) const {
    warn(reason);
    return count(false, Usable::kNoPose);
}

}  // namespace clearway::planning
