#include "clearway/planning/valid_state_samplers.h"

#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>

#include <algorithm>

#include "clearway/errors.h"

namespace clearway::planning {
namespace {

namespace ob = ompl::base;

constexpr double kWantedPerDiagonal = 0.01;
constexpr double kBesidePerExtent = 0.1;  ///< of the space's extent, as in OMPL's Gaussian sampler
constexpr int kContactHalvings = 6;       ///< between a state that collides and a valid one
constexpr int kMoves = 5;                 ///< away from contact
constexpr double kMoveMore = 1.05;        ///< of the missing clearance, because the next obstacle takes some

constexpr double kGapPerDiagonal = 0.1;
constexpr int kMostGapSteps = 16;       ///< across a gap
constexpr double kStepShare = 0.9;      ///< of the clearance, so that a step touches nothing yet
constexpr double kLeastGapStep = 0.02;  ///< of the gap's width
constexpr int kGapHalvings = 5;         ///< to the middle of a gap
constexpr double kOpposite = -0.3;      ///< the largest cosine between the normals of a gap's two sides

std::shared_ptr<const ValidityChecker> checkerOf(const ob::SpaceInformation& si, const char* sampler) {
    auto checker = std::dynamic_pointer_cast<const ValidityChecker>(si.getStateValidityChecker());
    if (checker) return checker;
    throw ArgumentError(std::string("the sampler ") + sampler +
                        " was given a space information whose validity checker is none of "
                        "clearway's, expected clearway::planning::ValidityChecker");
}

bool isPlanar(const ob::StateSpace& space, const char* sampler) {
    if (dynamic_cast<const ob::SE2StateSpace*>(&space)) return true;
    if (dynamic_cast<const ob::SE3StateSpace*>(&space)) return false;
    throw ArgumentError(std::string("the sampler ") + sampler + " was given the state space '" +
                        space.getName() + "', expected SE(3) or SE(2)");
}

}  // namespace

WitnessSampler::WitnessSampler(const ob::SpaceInformation* si, const char* name)
    : ob::ValidStateSampler(si),
      checker_(checkerOf(*si, name)),
      sampler_(si->allocStateSampler()),
      isPlanar_(isPlanar(*si->getStateSpace(), name)) {
    name_ = name;
    other_ = si->allocState();
}

WitnessSampler::~WitnessSampler() {
    si_->freeState(other_);
}

bool WitnessSampler::sample(ob::State* state) {
    for (unsigned int i = 0; i < attempts_; ++i) {
        sampler_->sampleUniform(state);
        if (settle(state)) return true;
    }
    return false;
}

bool WitnessSampler::sampleNear(ob::State* state, const ob::State* near, double distance) {
    for (unsigned int i = 0; i < attempts_; ++i) {
        sampler_->sampleUniformNear(state, near, distance);
        if (settle(state) && si_->distance(state, near) <= distance) return true;
    }
    return false;
}

WitnessSampler::StateClearance WitnessSampler::clearanceAt(const ob::State* state) const {
    StateClearance found;
    found.isValid = checker_->isValid(state, found.clearance);
    if (!found.isValid) return found;
    const SceneDistance nearest = checker_->distance(state);
    if (!nearest.witness) return found;
    Vector3 away = nearest.witness->pointOnPart - nearest.witness->pointOnEnvironment;
    if (isPlanar_) away.z() = 0;
    const double length = away.norm();
    if (length > 0) found.away = away / length;
    return found;
}

void WitnessSampler::translate(ob::State* state, const Vector3& by) const {
    if (isPlanar_) {
        auto* se2 = state->as<ob::SE2StateSpace::StateType>();
        se2->setXY(se2->getX() + by.x(), se2->getY() + by.y());
    } else {
        auto* se3 = state->as<ob::SE3StateSpace::StateType>();
        se3->setXYZ(se3->getX() + by.x(), se3->getY() + by.y(), se3->getZ() + by.z());
    }
}

double WitnessSampler::partDiagonal() const {
    return checker_->scene().part.box().diagonal().norm();
}

ContactNormalSampler::ContactNormalSampler(const ob::SpaceInformation* si)
    : WitnessSampler(si, "contact_normal"),
      wanted_(kWantedPerDiagonal * partDiagonal()),
      beside_(kBesidePerExtent * si->getMaximumExtent()) {
    free_ = si->allocState();
    params_.declareParam<double>(
        "clearance", [this](double clearance) { wanted_ = clearance; }, [this] { return wanted_; });
}

ContactNormalSampler::~ContactNormalSampler() {
    si_->freeState(free_);
}

/// Settles for the state as drawn or, where that collides, for one beside the obstacle.
bool ContactNormalSampler::settle(ob::State* state) {
    if (checker_->isValid(state)) return pushAway(state);
    sampler_->sampleGaussian(free_, state, beside_);
    if (!checker_->isValid(free_)) return false;
    double blocked = 0, valid = 1;  // of the motion from the state to free_
    for (int i = 0; i < kContactHalvings; ++i) {
        const double middle = 0.5 * (blocked + valid);
        si_->getStateSpace()->interpolate(state, free_, middle, other_);
        (checker_->isValid(other_) ? valid : blocked) = middle;
    }
    si_->getStateSpace()->interpolate(state, free_, valid, other_);
    si_->copyState(state, other_);
    return pushAway(state);
}

bool ContactNormalSampler::pushAway(ob::State* state) const {
    StateClearance found = clearanceAt(state);
    for (int i = 0; i < kMoves && found.isValid && found.clearance < wanted_; ++i) {
        if (found.away.isZero()) break;
        si_->copyState(other_, state);
        translate(other_, kMoveMore * (wanted_ - found.clearance) * found.away);
        const StateClearance moved = clearanceAt(other_);
        if (!moved.isValid || moved.clearance <= found.clearance) break;  // the part can get no farther away
        si_->copyState(state, other_);
        found = moved;
    }
    return found.isValid;
}

NarrowGapSampler::NarrowGapSampler(const ob::SpaceInformation* si)
    : WitnessSampler(si, "narrow_gap"), gap_(kGapPerDiagonal * partDiagonal()) {
    params_.declareParam<double>(
        "gap", [this](double gap) { gap_ = gap; }, [this] { return gap_; });
}

/// Tries the drawn state, a valid state about a gap's width beside it, or the middle between two states that
/// collide.
bool NarrowGapSampler::settle(ob::State* state) {
    if (checker_->isValid(state)) return centre(state);
    sampler_->sampleGaussian(other_, state, gap_);
    if (!checker_->isValid(other_)) si_->getStateSpace()->interpolate(state, other_, 0.5, other_);
    si_->copyState(state, other_);
    return centre(state);
}

/// Moves across the gap, away from the nearest obstacle, until another obstacle is nearer or in the way.
bool NarrowGapSampler::centre(ob::State* state) const {
    const StateClearance begin = clearanceAt(state);
    if (!begin.isValid || begin.clearance > 0.5 * gap_ || begin.away.isZero()) return false;
    double width = 0;
    StateClearance found = begin;
    for (int i = 0; i < kMostGapSteps; ++i) {
        width += std::max(kStepShare * found.clearance, kLeastGapStep * gap_);
        if (width > gap_) return false;
        si_->copyState(other_, state);
        translate(other_, width * begin.away);
        if (!si_->satisfiesBounds(other_)) return false;  // the bounds are no obstacle
        found = clearanceAt(other_);
        if (!found.isValid || found.away.dot(begin.away) <= kOpposite) {
            balance(state, begin.away, width);
            return checker_->clearance(state) <= 0.5 * gap_;
        }
    }
    return false;
}

/// Leaves the state where both sides of the gap are about equally near. When the part has moved by 0, the
/// near side is nearer; when it has moved by `width`, the far side is.
void NarrowGapSampler::balance(ob::State* state, const Vector3& away, double width) const {
    double near = 0, far = width;
    for (int i = 0; i < kGapHalvings; ++i) {
        const double middle = 0.5 * (near + far);
        si_->copyState(other_, state);
        translate(other_, middle * away);
        const StateClearance found = clearanceAt(other_);
        const bool isFarNearer = !found.isValid || found.away.dot(away) < 0;
        (isFarNearer ? far : near) = middle;
    }
    // The state at every value that `near` took was valid.
    translate(state, near * away);
}

}  // namespace clearway::planning
