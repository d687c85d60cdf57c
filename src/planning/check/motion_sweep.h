// Certifies a motion pair by pair, by sweeps of the part past each obstacle.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "clearway/planning/motion_validator.h"
#include "planning/check/motion.h"
#include "planning/check/motion_search.h"

namespace clearway::planning {

/// For motions that can be swept; see Motion::canBeSwept. The functions are those of MotionSearch.
class MotionSweep {
  public:
    /// The motion has been measured. Lengths and isStopped as in MotionSearch's constructor.
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
    bool leavesBounds() const { return leavesBounds_; }

    /// Finds the least clearance of a motion that goForward found valid.
    double refineLower(const ClearanceResolution& resolution);

    /// Finds the least clearance of a motion in place of certify or goForward: see MotionSearch.
    std::optional<double> leastClearance(double cap, const ClearanceResolution& resolution,
                                         bool isForReverse = false);

    /// The intervals up to certifiedTime() in order: see MotionSearch.
    std::vector<MotionInterval> profile(double share);

  private:
    MotionVerdict lookBehindUndecided();
    MotionVerdict invalidStart();

    Motion& motion_;
    SceneSweepOptions options_;
    double certifiedTime_ = 0;
    double blockedTime_ = 1;
    bool leavesBounds_ = false;
    bool isStartInvalid_ = false;
    std::optional<double> least_;  ///< clearance of the whole motion, if it is known
};

}  // namespace clearway::planning
