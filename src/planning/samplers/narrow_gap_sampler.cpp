#include <algorithm>

#include "clearway/planning/valid_state_samplers.h"

namespace clearway::planning {
namespace {

namespace ob = ompl::base;

constexpr double kGapPerDiagonal = 0.1;
constexpr int kMostSteps = 16;       ///< across a gap
constexpr double kStepShare = 0.9;   ///< of the clearance: a step that touches nothing yet
constexpr double kLeastStep = 0.02;  ///< of the gap's width
constexpr int kHalvings = 5;         ///< to the middle
constexpr double kOpposite = -0.3;   ///< cosine between the two obstacles' normals, at most

}  // namespace

NarrowGapSampler::NarrowGapSampler(const ob::SpaceInformation* si)
    : WitnessSampler(si, "narrow_gap"), gap_(kGapPerDiagonal * partDiagonal()) {
    params_.declareParam<double>(
        "gap", [this](double gap) { gap_ = gap; }, [this] { return gap_; });
}

bool NarrowGapSampler::sample(ob::State* state) {
    for (unsigned int i = 0; i < attempts_; ++i) {
        sampler_->sampleUniform(state);
        if (findGap(state)) return true;
    }
    return false;
}

bool NarrowGapSampler::sampleNear(ob::State* state, const ob::State* near, double distance) {
    for (unsigned int i = 0; i < attempts_; ++i) {
        sampler_->sampleUniformNear(state, near, distance);
        if (findGap(state) && si_->distance(state, near) <= distance) return true;
    }
    return false;
}

/// The state, a valid one a gap's width or so beside it, or the middle between two that collide.
bool NarrowGapSampler::findGap(ob::State* state) {
    if (checker_->isValid(state)) return centre(state);
    sampler_->sampleGaussian(other_, state, gap_);
    if (!checker_->isValid(other_)) si_->getStateSpace()->interpolate(state, other_, 0.5, other_);
    si_->copyState(state, other_);
    return centre(state);
}

/// Moves across, away from the nearest obstacle, until another one is nearer, or in the way.
bool NarrowGapSampler::centre(ob::State* state) const {
    const Room begin = roomAt(state);
    if (!begin.isValid || begin.clearance > 0.5 * gap_ || begin.away.isZero()) return false;
    double width = 0;
    Room room = begin;
    for (int i = 0; i < kMostSteps; ++i) {
        width += std::max(kStepShare * room.clearance, kLeastStep * gap_);
        if (width > gap_) return false;
        si_->copyState(other_, state);
        translate(other_, width * begin.away);
        if (!si_->satisfiesBounds(other_)) return false;  // which are no obstacle
        room = roomAt(other_);
        if (!room.isValid || room.away.dot(begin.away) <= kOpposite) {
            balance(state, begin.away, width);
            return checker_->clearance(state) <= 0.5 * gap_;
        }
    }
    return false;
}

/// Leaves the state where both sides are about as near. At 0 the near side is nearer, at `width` the far
/// side.
void NarrowGapSampler::balance(ob::State* state, const Vector3& away, double width) const {
    double near = 0, far = width;
    for (int i = 0; i < kHalvings; ++i) {
        const double middle = 0.5 * (near + far);
        si_->copyState(other_, state);
        translate(other_, middle * away);
        const Room room = roomAt(other_);
        const bool isFarNearer = !room.isValid || room.away.dot(away) < 0;
        (isFarNearer ? far : near) = middle;
    }
    // `near` was valid whenever it was moved, so that the state is.
    translate(state, near * away);
}

}  // namespace clearway::planning
