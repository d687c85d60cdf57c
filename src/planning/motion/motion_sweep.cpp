#include "planning/motion/motion_sweep.h"

#include <algorithm>

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
    options_.leastInterval = std::max(leastInterval, 4 * motion.slack());
    options_.contactInterval = std::max(contactInterval, 4 * motion.slack());
    options_.isStopped = std::move(isStopped);
}

MotionVerdict MotionSweep::certify() {
    if (!motion_.isStartWithinBounds()) return invalidStart();
    const MotionVerdict verdict = verdictOf(motion_.sweep(options_).verdict);
    if (verdict == MotionVerdict::kValid && !motion_.doesEndKeepFloor()) return MotionVerdict::kInvalid;
    if (verdict == MotionVerdict::kInvalid && !motion_.isFreeAtStart()) return invalidStart();
    return verdict;
}

MotionVerdict MotionSweep::invalidStart() {
    isStartInvalid_ = true;
    certifiedTime_ = blockedTime_ = 0;
    return MotionVerdict::kInvalid;
}

/// A pose in collision is cheap to find, so the motion is halved until its middle is free before it is swept.
MotionVerdict MotionSweep::goForward() {
    if (!motion_.isStartWithinBounds()) return invalidStart();
    options_.isForward = true;
    options_.until = motion_.timeWithinBounds(options_.leastInterval);
    const bool leavesBounds = options_.until < 1;
    bool isBlocked = false;
    for (double time = options_.until; motion_.length() * time > options_.contactInterval; time *= 0.5) {
        if (motion_.isFreeAt(time)) break;
        isBlocked = true;
        options_.until = time;
    }
    options_.isContactAtEnd = isBlocked;
    const SceneSweep found = motion_.sweep(options_);
    certifiedTime_ = found.certifiedUntil;
    // Where no surfaces touch, solids hold the part at the start or at no pose.
    if ((certifiedTime_ == 0 || motion_.hasSolids()) && !motion_.isFreeAtStart()) return invalidStart();
    blockedTime_ = isBlocked ? options_.until : 1;
    if (found.verdict != SweepVerdict::kCertified) {
        blockedTime_ = std::min(found.contactTime, blockedTime_);
        return isBlocked ? MotionVerdict::kInvalid : verdictOf(found.verdict);
    }
    if (leavesBounds || isBlocked) return MotionVerdict::kInvalid;
    if (motion_.isEndValid()) return MotionVerdict::kValid;
    if (!motion_.isFreeAtStart()) return invalidStart();
    constexpr double kJustBeforeEnd = 1 - 0x1p-53;
    certifiedTime_ = kJustBeforeEnd;
    return MotionVerdict::kInvalid;
}

}  // namespace clearway::planning
