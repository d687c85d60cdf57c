#include "clearway/planning/valid_state_samplers.h"

namespace clearway::planning {
namespace {

namespace ob = ompl::base;

constexpr double kWantedPerDiagonal = 0.01;
constexpr double kBesidePerExtent = 0.1;  ///< of the space, as OMPL's Gaussian sampler
constexpr int kHalvings = 6;              ///< between a state that collides and a valid one
constexpr int kMoves = 5;                 ///< away from contact
constexpr double kMoveMore = 1.05;        ///< than is lacking: the next obstacle takes some

}  // namespace

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

bool ContactNormalSampler::sample(ob::State* state) {
    for (unsigned int i = 0; i < attempts_; ++i) {
        sampler_->sampleUniform(state);
        if (settle(state)) return true;
    }
    return false;
}

bool ContactNormalSampler::sampleNear(ob::State* state, const ob::State* near, double distance) {
    for (unsigned int i = 0; i < attempts_; ++i) {
        sampler_->sampleUniformNear(state, near, distance);
        if (settle(state) && si_->distance(state, near) <= distance) return true;
    }
    return false;
}

/// The state as drawn, or one beside what it touches.
bool ContactNormalSampler::settle(ob::State* state) {
    if (checker_->isValid(state)) return pushAway(state);
    sampler_->sampleGaussian(free_, state, beside_);
    if (!checker_->isValid(free_)) return false;
    double blocked = 0, valid = 1;  // of the motion from the state to free_
    for (int i = 0; i < kHalvings; ++i) {
        const double middle = 0.5 * (blocked + valid);
        si_->getStateSpace()->interpolate(state, free_, middle, other_);
        (checker_->isValid(other_) ? valid : blocked) = middle;
    }
    si_->getStateSpace()->interpolate(state, free_, valid, other_);
    si_->copyState(state, other_);
    return pushAway(state);
}

bool ContactNormalSampler::pushAway(ob::State* state) const {
    Room room = roomAt(state);
    for (int i = 0; i < kMoves && room.isValid && room.clearance < wanted_; ++i) {
        if (room.away.isZero()) break;
        si_->copyState(other_, state);
        translate(other_, kMoveMore * (wanted_ - room.clearance) * room.away);
        const Room moved = roomAt(other_);
        if (!moved.isValid || moved.clearance <= room.clearance) break;  // this is as far as it goes
        si_->copyState(state, other_);
        room = moved;
    }
    return room.isValid;
}

}  // namespace clearway::planning
