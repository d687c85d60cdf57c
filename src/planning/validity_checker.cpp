#include "clearway/planning/validity_checker.h"

#include <ompl/util/Console.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "planning/thread_workspace.h"

namespace clearway::planning {

namespace ob = ompl::base;

namespace {

bool isOutOfReach(const Model& environment, const Pose& X_environmentPart) {
    const std::optional<Reach>& reach = environment.reach();
    return reach && !reach->positions.contains(X_environmentPart.translation);
}

}  // namespace

ValidityChecker::ValidityChecker(const ob::SpaceInformationPtr& si, Scene scene)
    : ValidityChecker(si, std::move(scene), planning::stateToPose(*si->getStateSpace())) {}

ValidityChecker::ValidityChecker(const ob::SpaceInformationPtr& si, Scene scene, StateToPose stateToPose)
    : StateValidityChecker(si),
      scene_(std::move(scene)),
      stateToPose_(std::move(stateToPose)),
      id_(newWorkspaceOwner()) {
    if (!stateToPose_) throw std::invalid_argument("stateToPose is empty, expected a function");
    if (!(scene_.margin >= 0) || !std::isfinite(scene_.margin)) {
        std::ostringstream message;
        message << "margin is " << scene_.margin << ", expected a finite number >= 0";
        throw std::invalid_argument(message.str());
    }
    specs_.clearanceComputationType = ob::StateValidityCheckerSpecs::BOUNDED_APPROXIMATE;
    specs_.hasValidDirectionComputation = false;
    // Models that cannot be queried together are the caller's mistake: better told here than inside a
    // planner.
    Pose somewhere;
    if (const auto& reach = scene_.environment.reach()) somewhere.translation = reach->positions.center();
    isFree(somewhere);
}

bool ValidityChecker::isValid(const ob::State* state) const {
    Pose X_environmentPart;
    const Usable usable = findPose(state, X_environmentPart);
    if (usable != Usable::kYes) return count(false, usable);
    try {
        return count(isFree(X_environmentPart), usable);
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
    if (usable == Usable::kOutOfBounds && isOutOfReach(scene_.environment, X_environmentPart)) {
        clearance = 0 - scene_.margin;  // of a distance that is at least 0
        return count(false, usable);
    }
    try {
        clearance = signedClearance(X_environmentPart);
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

DistanceResult ValidityChecker::distance(const ob::State* state) const {
    return clearway::distance(scene_.part, scene_.environment, pose(state), {}, threadWorkspace(id_));
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

bool ValidityChecker::isFree(const Pose& X_environmentPart) const {
    Workspace& workspace = threadWorkspace(id_);
    if (scene_.margin == 0) return !collides(scene_.part, scene_.environment, X_environmentPart, workspace);
    return !isWithin(scene_.part, scene_.environment, X_environmentPart, scene_.margin, workspace);
}

// lower > margin and upper <= margin decide at once; only an interval that holds the margin asks a second
// time.
double ValidityChecker::signedClearance(const Pose& X_environmentPart) const {
    Workspace& workspace = threadWorkspace(id_);
    const DistanceResult d =
        clearway::distance(scene_.part, scene_.environment, X_environmentPart, {}, workspace);
    const double above = d.lower - scene_.margin;
    const bool isSure = scene_.margin == 0 || d.lower > scene_.margin || d.upper <= scene_.margin;
    const bool valid = isSure ? d.upper > scene_.margin : isFree(X_environmentPart);
    return valid ? std::max(above, std::numeric_limits<double>::denorm_min()) : std::min(above, 0.0);
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
