// Which poses of a motion to look at, until it is certified or something is in the way.
#pragma once

#include <algorithm>
#include <vector>

#include "clearway/planning/motion_validator.h"
#include "planning/motion.h"

namespace clearway::planning {

/// From one sample to the next one along the motion. lower: no pose between them has less clearance; above 0
/// the interval is certified.
struct MotionInterval {
    MotionSample from, to;
    double lower = 0;
};

/// How well the least clearance of a motion is to be known: to `share` of it, or to `length` where that is
/// more, but no worse than to `largestShare` of it, unless it is less than `least`.
struct ClearanceResolution {
    double share, largestShare, length, least;
    double of(double clearance) const {
        return std::max({share * clearance, std::min(largestShare * clearance, length), least});
    }
};

class MotionSearch {
  public:
    /// leastInterval, contactInterval: what is not certified is given up when it is this short; the latter
    /// where an invalid pose is at its end.
    MotionSearch(Motion& motion, double leastInterval, double contactInterval);

    /// The far end first, then the middle of the widest stretch that is not certified.
    MotionVerdict certify();

    /// From the start to the end. certifiedTime() tells how far it came.
    MotionVerdict goForward();

    double certifiedTime() const { return reached_.time; }
    bool isStartInvalid() const { return isStartInvalid_; }

    /// Looks at more poses of a motion that goForward found valid, where the clearance may be least, until
    /// its least over all intervals is known well enough. Returns that: no pose has less.
    double refineLower(const ClearanceResolution& resolution);

  private:
    /// What two samples leave open between them, as a length, and where to divide it.
    struct Stretch {
        double open;
        double time;
    };

    void measure();
    double spare(const MotionSample& from, const MotionSample& to) const;
    MotionInterval interval(const MotionSample& from, const MotionSample& to) const;
    bool isCertified(const MotionSample& from, const MotionSample& to) const {
        return interval(from, to).lower > 0;
    }
    double dividingTime(const MotionSample& from, const MotionSample& to) const;
    double wantedFor(double open) const;
    double wantedAtEnds() const;
    bool lookAtStart();
    void keepOpen(const MotionInterval& added);
    Stretch stretchBefore(const MotionSample& next) const;
    void advance(const MotionSample& next);
    void stopBefore(const MotionSample& blocked, double stop);

    Motion& motion_;
    double leastInterval_;
    double contactInterval_;
    MotionSample reached_;
    bool isStartInvalid_ = false;
    std::vector<MotionInterval> intervals_;  ///< certify: a heap of the open ones; else the certified ones
};

}  // namespace clearway::planning
