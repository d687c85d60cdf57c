// Certifies a motion pair by pair, by sweeps of the part past each obstacle, and finds its least clearance.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "clearway/planning/motion_validator.h"
#include "planning/check/motion.h"

namespace clearway::planning {

/// The interval from one sample to the next one along the motion. No pose of it has less clearance from the
/// obstacles that count there than `lower`; 0 where no more is known than that the poses are valid.
struct MotionInterval {
    MotionSample from, to;
    double lower = 0;
};

class MotionSweep {
  public:
    /// The motion has been measured. A stretch that is not certified is given up when it is as short as leastInterval, or as
    /// contactInterval where an invalid pose is at its end. isStopped: MotionOptions::isStopped, may be
    /// empty.
    MotionSweep(Motion& motion, double leastInterval, double contactInterval,
                std::function<bool()> isStopped = {});

    /// Looks at s2 first, unless the motion is short.
    MotionVerdict certify();

    /// Goes from the start to the end. certifiedTime() is how far it came.
    MotionVerdict goForward();

    /// Goes forward for a report, which wants the least clearance of a valid motion.
    MotionVerdict goForwardToReport(const ClearanceResolution& resolution);

    double certifiedTime() const { return certifiedTime_; }
    MotionSample reached();
    bool isStartInvalid() const { return isStartInvalid_; }

    /// The pose that ended goForward, unless the motion is valid.
    double blockedTime() const { return blockedTime_; }

    /// Finds the least clearance of a motion that goForward found valid. Returns a clearance that no pose is below.
    double refineLower(const ClearanceResolution& resolution);

    /// Looks at a motion, in place of certify or goForward, until its least clearance is known well enough or
    /// known to be `cap` but for the resolution. Returns a clearance that no pose is below. It may be more
    /// than the cap, and is at most 0 when the motion cannot be told from an invalid one. Returns nothing
    /// when a pose is invalid. isForReverse: the bound is to hold for the motion from s2 to s1, too.
    std::optional<double> leastClearance(double cap, const ClearanceResolution& resolution,
                                         bool isForReverse = false);

    /// The intervals up to certifiedTime() in order, divided until each interval's bound is at
    /// least `share` of the lesser leeway at its ends, or the interval is as short as the least interval.
    std::vector<MotionInterval> profile(double share);

  private:
    SceneSweep sweepUpTo(double border);
    MotionVerdict lookBehindUndecided();
    MotionVerdict invalidStart();
    MotionVerdict judgeEnds();

    Motion& motion_;
    SceneSweepOptions options_;
    double certifiedTime_ = 0;
    double blockedTime_ = 1;
    bool isStartInvalid_ = false;
    std::optional<double> least_;  ///< clearance of the whole motion, if it is known
};

}  // namespace clearway::planning
