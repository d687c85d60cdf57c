#include "planning/objectives/objective_motions.h"

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "clearway/planning/validity_checker.h"
#include "core/number.h"
#include "planning/motion/motion_search.h"
#include "planning/validity/space_of.h"

namespace clearway::planning {
namespace {

namespace ob = ompl::base;

/// An order of any two states, the same whichever comes first.
bool isInOrder(const ob::StateSpace& space, const ob::State* a, const ob::State* b) {
    if (!space.hasSymmetricInterpolate()) return true;  // the two directions are two motions
    std::vector<unsigned char> ofA(space.getSerializationLength()), ofB(ofA.size());
    space.serialize(ofA.data(), a);
    space.serialize(ofB.data(), b);
    return ofA <= ofB;
}

}  // namespace

const Scene& sceneOf(const ob::SpaceInformationPtr& si) {
    spaceOf(si);
    const auto* checker = dynamic_cast<const ValidityChecker*>(si->getStateValidityChecker().get());
    if (checker != nullptr) return checker->scene();
    throw std::invalid_argument(
        "there is no scene: the space information's validity checker is none of clearway's, expected "
        "a clearway::planning::ValidityChecker to be set before");
}

ObjectiveMotions::ObjectiveMotions(const ob::SpaceInformationPtr& si, Scene scene)
    : ObjectiveMotions(si, scene, planning::stateToPose(spaceOf(si)),
                       displacementBound(spaceOf(si), scene.part)) {
    areBoundsConvex_ = true;
}

ObjectiveMotions::ObjectiveMotions(const ob::SpaceInformationPtr& si, Scene scene, StateToPose stateToPose,
                                   DisplacementBound bound)
    : si_(si),
      clearance_(std::move(scene)),
      stateToPose_(std::move(stateToPose)),
      bound_(std::move(bound)),
      leastInterval_(defaultLeastInterval(clearance_.scene())) {
    spaceOf(si);
    if (!stateToPose_) throw std::invalid_argument("stateToPose is empty, expected a function");
    if (!bound_) throw std::invalid_argument("the displacement bound is empty, expected a function");
    if (!(mostClearance() > 0)) {
        throw std::invalid_argument("an obstacle was built with a reach that ends " +
                                    shortNumber(mostClearance()) +
                                    " beyond its margin, expected more than 0");
    }
}

std::optional<double> ObjectiveMotions::clearanceAt(const ob::State* state, double cap) const {
    const Pose X_environmentPart = stateToPose_(state);
    requirePose(X_environmentPart);
    if (!si_->satisfiesBounds(state)) return std::nullopt;
    ClearanceOptions options;
    options.cap = cap;
    const PoseClearance found = clearance_.at(X_environmentPart, options);
    queries_.fetch_add(found.queries, std::memory_order_relaxed);
    if (!found.isValid()) return std::nullopt;
    return std::min(cap, found.lower);
}

/// A warm start may change a distance's last digits.
Motion ObjectiveMotions::motionBetween(const ob::State* s1, const ob::State* s2) const {
    clearance_.forgetWarmStart();
    if (!isInOrder(*si_->getStateSpace(), s1, s2)) std::swap(s1, s2);
    return Motion({*si_, clearance_, stateToPose_, bound_, areBoundsConvex_, ClearanceDetail::kTight}, s1,
                  s2);
}

double ObjectiveMotions::unusable(const char* reason, double cost) const {
    unusable_.fetch_add(1, std::memory_order_relaxed);
    if (!isLogged_.exchange(true, std::memory_order_relaxed)) {
        OMPL_WARN("clearway: an objective gave the worst cost: %s. Further ones are only counted.", reason);
    }
    return cost;
}

ObjectiveCounters ObjectiveMotions::counters() const {
    const auto read = [](const std::atomic<std::uint64_t>& counter) {
        return counter.load(std::memory_order_relaxed);
    };
    return {read(motions_), read(invalid_), read(unusable_), read(queries_)};
}

ClearanceObjective::ClearanceObjective(const ob::SpaceInformationPtr& si, Scene scene)
    : OptimizationObjective(si), motions_(std::make_unique<ObjectiveMotions>(si, std::move(scene))) {}

ClearanceObjective::ClearanceObjective(const ob::SpaceInformationPtr& si, Scene scene,
                                       StateToPose stateToPose, DisplacementBound bound)
    : OptimizationObjective(si),
      motions_(std::make_unique<ObjectiveMotions>(si, std::move(scene), std::move(stateToPose),
                                                  std::move(bound))) {}

ClearanceObjective::~ClearanceObjective() = default;

const Scene& ClearanceObjective::scene() const {
    return motions_->scene();
}

ObjectiveCounters ClearanceObjective::counters() const {
    return motions_->counters();
}

}  // namespace clearway::planning
