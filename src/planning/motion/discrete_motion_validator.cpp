#include "clearway/planning/discrete_motion_validator.h"

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "planning/validity/ompl_states.h"
#include "planning/validity/posed_scene.h"

namespace clearway::planning {
namespace {

namespace ob = ompl::base;

/// More checks than this would take days, so that the motion counts as one that cannot be checked.
constexpr double kMostParts = 1 << 30;

double fraction(std::uint64_t i, std::uint64_t n) {
    return static_cast<double>(i) / static_cast<double>(n);
}

}  // namespace

DiscreteMotionValidator::DiscreteMotionValidator(const ob::SpaceInformationPtr& si, const Model& part,
                                                 double step, std::function<bool()> isStopped)
    : DiscreteMotionValidator(si, displacementBound(spaceOf(si), part.radiusAboutOrigin()), step,
                              std::move(isStopped)) {}

DiscreteMotionValidator::DiscreteMotionValidator(const ob::SpaceInformationPtr& si, DisplacementBound bound,
                                                 double step, std::function<bool()> isStopped)
    : MotionValidator(si),
      posed_(std::make_shared<const PosedScene>(si, std::move(bound))),
      step_(step),
      isStopped_(std::move(isStopped)) {
    if (!(step > 0) || !std::isfinite(step)) {
        std::ostringstream message;
        message << "step is " << step << ", expected a finite length above 0";
        throw std::invalid_argument(message.str());
    }
}

bool DiscreteMotionValidator::checkMotion(const ob::State* s1, const ob::State* s2) const {
    return count(isMotionValid(s1, s2));
}

bool DiscreteMotionValidator::checkMotion(const ob::State* s1, const ob::State* s2,
                                          std::pair<ob::State*, double>& lastValid) const {
    const double time = lastValidTime(s1, s2);
    if (time >= 1) return count(true);
    setLastValid(*si_, s1, s2, time, lastValid);
    return count(false);
}

std::uint64_t DiscreteMotionValidator::partsOf(const ob::State* s1, const ob::State* s2) const {
    const double whole = posed_->bound(s1, s2);
    if (!std::isfinite(whole))
        return 0;  // before OMPL interpolates, because Debian's asserts unit quaternions
    const ScratchState end(*si_);
    si_->getStateSpace()->interpolate(s1, s2, 1, end.get());
    const double jump = posed_->bound(end.get(), s2);  // comes on top of the last part's own displacement
    const double parts = std::ceil(whole / (step_ - jump));
    if (!(jump < step_) || !(parts <= kMostParts)) return 0;
    return parts < 1 ? 1 : static_cast<std::uint64_t>(parts);
}

// Looks at s2 first, then at ever finer halves, because that order is likely to find a collision early.
bool DiscreteMotionValidator::isMotionValid(const ob::State* s1, const ob::State* s2) const {
    const std::uint64_t n = partsOf(s1, s2);
    if (n == 0 || !si_->isValid(s2)) return false;
    const ScratchState scratch(*si_);
    std::uint64_t stride = 1;
    while (stride < n) stride *= 2;
    for (stride /= 2; stride >= 1; stride /= 2) {
        for (std::uint64_t i = stride; i < n; i += 2 * stride) {
            if (!isPartValid(s1, s2, i, n, scratch.get())) return false;
        }
    }
    return isStartValid(s1);
}

double DiscreteMotionValidator::lastValidTime(const ob::State* s1, const ob::State* s2) const {
    const std::uint64_t n = partsOf(s1, s2);
    if (!isStartValid(s1) || n == 0) return 0;
    const ScratchState scratch(*si_);
    for (std::uint64_t i = 1; i <= n; ++i) {
        if (!isPartValid(s1, s2, i, n, scratch.get())) return fraction(i - 1, n);
    }
    return 1;
}

/// Whether the state at i/n is valid. The far end is s2 itself, which OMPL's interpolation may miss.
bool DiscreteMotionValidator::isPartValid(const ob::State* s1, const ob::State* s2, std::uint64_t i,
                                          std::uint64_t n, ob::State* scratch) const {
    if (isStopped_ && isStopped_()) return false;
    if (i < n) si_->getStateSpace()->interpolate(s1, s2, fraction(i, n), scratch);
    return si_->isValid(i < n ? scratch : s2);
}

bool DiscreteMotionValidator::isStartValid(const ob::State* s1) const {
    const bool valid = si_->isValid(s1);
    if (!valid) posed_->count(Count::kInvalidStarts);
    return valid;
}

std::uint64_t DiscreteMotionValidator::invalidStarts() const {
    return posed_->counted(Count::kInvalidStarts);
}

bool DiscreteMotionValidator::count(bool valid) const {
    countAtomically(valid ? valid_ : invalid_);
    return valid;
}

}  // namespace clearway::planning
