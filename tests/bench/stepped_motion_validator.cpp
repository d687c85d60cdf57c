#include "bench/stepped_motion_validator.h"

#include <cmath>

#include "planning/space/ompl_states.h"

namespace clearway::testing {
namespace {

/// More checks than this would take days, so that the motion counts as one that cannot be checked.
constexpr double kMostParts = 1 << 30;

double fraction(std::uint64_t i, std::uint64_t n) {
    return static_cast<double>(i) / static_cast<double>(n);
}

}  // namespace

SteppedMotionValidator::SteppedMotionValidator(const ob::SpaceInformationPtr& si, const Model& part,
                                               double step)
    : MotionValidator(si),
      bound_(planning::displacementBound(*si->getStateSpace(), part.radiusAboutOrigin())),
      step_(step) {}

/// The number n of equal parts that the motion is checked in, at the times 0, 1/n, ..., 1. 0 when it cannot be checked.
std::uint64_t SteppedMotionValidator::partsOf(const ob::State* s1, const ob::State* s2) const {
    const double whole = bound_(s1, s2);
    if (!std::isfinite(whole))
        return 0;  // before OMPL interpolates, because Debian's asserts unit quaternions
    const planning::ScratchState end(*si_);
    si_->getStateSpace()->interpolate(s1, s2, 1, end.get());
    const double jump = bound_(end.get(), s2);  // comes on top of the last part's own displacement
    const double parts = std::ceil(whole / (step_ - jump));
    if (!(jump < step_) || !(parts <= kMostParts)) return 0;
    return parts < 1 ? 1 : static_cast<std::uint64_t>(parts);
}

// Looks at s2 first, then at ever finer halves, because that order is likely to find a collision early.
bool SteppedMotionValidator::checkMotion(const ob::State* s1, const ob::State* s2) const {
    const std::uint64_t n = partsOf(s1, s2);
    if (n == 0 || !si_->isValid(s2)) return false;
    const planning::ScratchState scratch(*si_);
    std::uint64_t stride = 1;
    while (stride < n) stride *= 2;
    for (stride /= 2; stride >= 1; stride /= 2) {
        for (std::uint64_t i = stride; i < n; i += 2 * stride) {
            if (!isPartValid(s1, s2, i, n, scratch.get())) return false;
        }
    }
    return si_->isValid(s1);
}

bool SteppedMotionValidator::checkMotion(const ob::State* s1, const ob::State* s2,
                                         std::pair<ob::State*, double>& lastValid) const {
    const std::uint64_t n = si_->isValid(s1) ? partsOf(s1, s2) : 0;
    const planning::ScratchState scratch(*si_);
    std::uint64_t i = 0;
    while (i < n && isPartValid(s1, s2, i + 1, n, scratch.get())) ++i;
    if (n > 0 && i == n) return true;
    planning::setLastValid(*si_, s1, s2, n > 0 ? fraction(i, n) : 0, lastValid);
    return false;
}

/// Whether the state at i/n is valid. The far end is s2 itself, which OMPL's interpolation may miss.
bool SteppedMotionValidator::isPartValid(const ob::State* s1, const ob::State* s2, std::uint64_t i,
                                         std::uint64_t n, ob::State* scratch) const {
    if (i < n) si_->getStateSpace()->interpolate(s1, s2, fraction(i, n), scratch);
    return si_->isValid(i < n ? scratch : s2);
}

}  // namespace clearway::testing
