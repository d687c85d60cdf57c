// Certifies a motion pair by pair, by sweeps of the part past each obstacle.
#pragma once

#include <functional>

#include "clearway/planning/motion_validator.h"
#include "planning/motion/motion.h"

namespace clearway::planning {

/// For motions that can be swept; see Motion::canBeSwept.
class MotionSweep {
  public:
    /// The motion has been measured. Lengths and isStopped as in MotionSearch's constructor.
    MotionSweep(Motion& motion, double leastInterval, double contactInterval, std::function<bool()> isStopped);

    /// The caller knows that s2 is valid.
    MotionVerdict certify();

    /// Goes from the start to the end. certifiedTime() is how far it came.
    MotionVerdict goForward();

    double certifiedTime() const { return certifiedTime_; }
    double blockedTime() const { return blockedTime_; }
    bool isStartInvalid() const { return isStartInvalid_; }

  private:
    MotionVerdict invalidStart();

    Motion& motion_;
    SceneSweepOptions options_;
    double certifiedTime_ = 0;
    double blockedTime_ = 1;
    bool isStartInvalid_ = false;
};

}  // namespace clearway::planning
