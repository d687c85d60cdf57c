#include "planning/check/motion_sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace clearway::planning {
namespace {

MotionVerdict verdictOf(SweepVerdict verdict) {
    switch (verdict) {
        case SweepVerdict::kCertified:
            return MotionVerdict::kValid;
        case SweepVerdict::kContact:
            return MotionVerdict::kInvalid;
        case SweepVerdict::kUndecided:
            break;
    }
    return MotionVerdict::kUndecided;
}

}  // namespace

/// Stretches shorter than a few slacks are not looked into, because a slack is rounding.
MotionSweep::MotionSweep(Motion& motion, double leastInterval, double contactInterval,
                         std::function<bool()> isStopped)
    : motion_(motion) {
    options_.floor = motion.floor();
    options_.poseError = 0.5 * motion.slack();
    options_.leastInterval = std::max(leastInterval, 4 * motion.slack());
    options_.contactInterval = std::max(contactInterval, 4 * motion.slack());
    options_.isStopped = std::move(isStopped);
}

MotionVerdict MotionSweep::certify() {
    if (!motion_.isStartWithinBounds()) return invalidStart();
    if (!motion_.isEndWithinBounds()) return MotionVerdict::kInvalid;
    if (motion_.length() == 0) return judgeEnds();
    if (!motion_.isShort() && !motion_.isEndClear()) return MotionVerdict::kInvalid;
    if (motion_.isWithinFloorBetween()) return MotionVerdict::kInvalid;
    const MotionVerdict verdict = verdictOf(motion_.sweep(options_).verdict);
    if (verdict == MotionVerdict::kInvalid && !motion_.isFreeAtStart()) return invalidStart();
    if (verdict != MotionVerdict::kValid) return verdict;
    motion_.followSide();
    if (!motion_.isEndLikeInterpolation()) return MotionVerdict::kInvalid;
    // s2 may be out of a solid that holds the part everywhere else: a turn that OMPL leaves out until the end leads far.
    if (motion_.hasSolids() && motion_.jumpsAtEnd() && !motion_.isFreeAtStart()) return invalidStart();
    return verdictOf(motion_.stayOutsideSolids(1, options_.leastInterval).verdict);
}

MotionVerdict MotionSweep::invalidStart() {
    isStartInvalid_ = true;
    certifiedTime_ = blockedTime_ = 0;
    return MotionVerdict::kInvalid;
}

/// A motion of length 0 is one pose, but for what s2 is off it.
MotionVerdict MotionSweep::judgeEnds() {
    const double wanted = 2 * motion_.slack();
    if (!motion_.atStart(wanted).isValid()) return invalidStart();
    if (!motion_.atEnd(wanted).isValid()) return MotionVerdict::kInvalid;
    certifiedTime_ = 1;
    return MotionVerdict::kValid;
}

/// A pose in collision is cheap to find, so the motion is halved until its middle is free before it is swept. Solids are asked last: a
/// sweep that gets to the middle shows on which side of them it is.
SceneSweep MotionSweep::sweepUpTo(double border) {
    double middle = border;
    const auto sweepFrom = [&](const auto& isFreeAt) {
        options_.isContactAtEnd = false;
        options_.until = border;
        double time = border;
        for (; motion_.length() * time > options_.contactInterval && !isFreeAt(time); time *= 0.5) {
            options_.isContactAtEnd = true;
            options_.until = time;
        }
        middle = time;
        return motion_.sweep(options_);
    };
    const auto isFreeAt = [&](double time) { return motion_.isFreeAt(time); };
    if (!motion_.areSidesKept()) return sweepFrom(isFreeAt);
    const SceneSweep found = sweepFrom([&](double time) { return motion_.isClearAt(time); });
    const bool isMiddleFree = found.certifiedUntil >= middle ||
                              motion_.length() * middle <= options_.contactInterval ||
                              motion_.isFreeAt(middle);
    return isMiddleFree ? found : sweepFrom(isFreeAt);
}

MotionVerdict MotionSweep::goForward() {
    motion_.forgetSide();
    if (!motion_.isStartWithinBounds()) return invalidStart();
    if (motion_.length() == 0) return judgeEnds();
    const TimeSpan border = motion_.leavesBounds(options_.leastInterval);
    if (border.first == 0) {
        blockedTime_ = border.last;
        return MotionVerdict::kInvalid;
    }
    options_.isForward = true;
    const SceneSweep found = sweepUpTo(border.first);
    certifiedTime_ = found.certifiedUntil;
    // Where no surfaces touch, solids hold the part at the start or at no pose.
    if ((certifiedTime_ == 0 || motion_.hasSolids()) && !motion_.isFreeAtStart()) return invalidStart();
    const SolidsAlong solids = motion_.stayOutsideSolids(certifiedTime_, options_.leastInterval);
    certifiedTime_ = solids.until;
    const bool isInside = solids.verdict == SweepVerdict::kContact;
    if (options_.isContactAtEnd || found.verdict == SweepVerdict::kContact || isInside) {
        blockedTime_ =
            std::min({found.contactTime.value_or(1), solids.contactTime.value_or(1), options_.until});
        if (blockedTime_ == 1 && motion_.isEndValid()) blockedTime_ = kJustBeforeEnd;
        return MotionVerdict::kInvalid;
    }
    if (found.verdict == SweepVerdict::kUndecided || solids.verdict == SweepVerdict::kUndecided) {
        blockedTime_ = certifiedTime_;
        return MotionVerdict::kUndecided;
    }
    if (border.first < 1) {
        blockedTime_ = border.last;
        return MotionVerdict::kInvalid;
    }
    motion_.followSide();
    if (motion_.isEndValid()) return MotionVerdict::kValid;
    if (!motion_.isFreeAtStart()) return invalidStart();
    certifiedTime_ = kJustBeforeEnd;
    return MotionVerdict::kInvalid;
}

MotionSample MotionSweep::reached() {
    constexpr double kFully = std::numeric_limits<double>::infinity();
    if (certifiedTime_ == 0) return motion_.atStart(kFully);
    return certifiedTime_ == 1 ? motion_.atEnd(kFully) : motion_.at(certifiedTime_, kFully);
}

double MotionSweep::refineLower(const ClearanceResolution& resolution) {
    if (!least_) least_ = leastClearance(std::numeric_limits<double>::infinity(), resolution);
    return std::max(least_.value_or(0), std::numeric_limits<double>::denorm_min());
}

/// A motion whose least clearance is above 0 is valid, and known closely enough for a report.
MotionVerdict MotionSweep::goForwardToReport(const ClearanceResolution& resolution) {
    if (motion_.isStartWithinBounds() && motion_.isEndWithinBounds()) {
        least_ = leastClearance(std::numeric_limits<double>::infinity(), resolution);
        if (least_ && *least_ > 0) {
            certifiedTime_ = 1;
            return MotionVerdict::kValid;
        }
    }
    const MotionVerdict verdict = goForward();
    return verdict == MotionVerdict::kUndecided ? lookBehindUndecided() : verdict;
}

/// Looks at poses behind a stretch that is too close to tell, at distances from it that double. A pose in contact makes the
/// motion invalid, however far behind it is. Where faces meet all at once, the first one is near.
MotionVerdict MotionSweep::lookBehindUndecided() {
    const double least = options_.leastInterval / motion_.length();
    for (double beyond = least; certifiedTime_ + beyond <= options_.until; beyond *= 2) {
        if (motion_.isFreeAt(certifiedTime_ + beyond)) continue;
        blockedTime_ = certifiedTime_ + beyond;
        return MotionVerdict::kInvalid;
    }
    return MotionVerdict::kUndecided;
}

std::optional<double> MotionSweep::leastClearance(double cap, const ClearanceResolution& resolution,
                                                  bool isForReverse) {
    if (motion_.length() == 0) {
        const MotionSample start = motion_.atStart(cap), end = motion_.atEnd(cap);
        if (!start.isValid() || !end.isValid()) return std::nullopt;
        return std::min(start.lower, end.lower) - (isForReverse ? motion_.slack() : 0);
    }
    LeastClearanceOptions options;
    options.cap = cap;
    options.resolution = resolution;
    options.resolution.least = std::max(resolution.least, options_.leastInterval);
    options.isStopped = options_.isStopped;
    const std::optional<LeastClearance> found = motion_.leastClearance(options, isForReverse);
    if (!found || motion_.stayOutsideSolids(1, options_.leastInterval).verdict != SweepVerdict::kCertified)
        return std::nullopt;
    return found->lower;
}

/// Between two points, a share of the lesser clearance of both is certified by a sweep of that stretch. When the validator
/// is stopped, what is left is one stretch that is known to be valid.
std::vector<MotionInterval> MotionSweep::profile(double share) {
    std::vector<MotionInterval> settled;
    if (certifiedTime_ == 0) return settled;
    constexpr double kFully = std::numeric_limits<double>::infinity();
    std::vector<MotionSample> ahead{reached()};
    MotionSample from = motion_.atStart(kFully);
    SceneSweepOptions options = options_;
    options.isForward = options.isContactAtEnd = false;
    while (!ahead.empty()) {
        const MotionSample to = ahead.back();
        const double step = to.time - from.time, middle = from.time + 0.5 * step;
        const double atEnds = std::min(from.leeway.lower, to.leeway.lower);
        const double wanted =
            std::isfinite(atEnds) ? atEnds - std::max((1 - share) * atEnds, motion_.profileWidth()) : 0;
        const double longest = motion_.longestProfiled(atEnds);
        const bool isShort =
            motion_.length() * step <= options.leastInterval || !(middle > from.time && middle < to.time);
        options.from = from.time;
        options.until = to.time;
        options.floor = std::max(wanted, 0.0);
        const bool isKnown = wanted <= least_.value_or(0);
        if (isShort || (options.isStopped && options.isStopped())) {
            settled.push_back({from, to, 0});
        } else if (motion_.length() * step <= longest &&
                   (isKnown || motion_.sweep(options).verdict == SweepVerdict::kCertified)) {
            settled.push_back({from, to, isKnown ? 0 : wanted});
        } else {
            ahead.push_back(motion_.at(middle, kFully));
            continue;
        }
        from = to;
        ahead.pop_back();
    }
    return settled;
}

}  // namespace clearway::planning
