// Chooses the poses of a motion to look at, until the motion is certified or something is in the way.
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <vector>

#include "clearway/planning/motion_validator.h"
#include "planning/check/motion.h"

namespace clearway::planning {

/// The interval from one sample to the next one along the motion. No pose of it has less clearance from the
/// obstacles that count there than `lower`; above 0 the interval is certified.
struct MotionInterval {
    MotionSample from, to;
    double lower = 0;
};

/// 1e-5 of the diagonal of the part's box, or of the environment's box when the part is a point.
double defaultLeastInterval(const Scene& scene);

/// Options for planning between a start and a goal of which the tighter one has `spareAtEnds` clearance: a
/// least interval of a tenth of that clearance where this is less than the default, but no less than a
/// thousandth of the default. So paths that begin at a tight start can be planned and audited.
MotionOptions planningMotions(const Scene& scene, double spareAtEnds);

/// Options for auditing a path with such ends: a sixteenth of planningMotions' interval, so that motions that
/// passed in one order of samples pass in another order.
MotionOptions auditMotions(const Scene& scene, double spareAtEnds);

/// The resolution of the least clearances in reports: 1 % or, where that is more, 1e-3 of the part's
/// diagonal, but no worse than 10 % or leastInterval.
ClearanceResolution usualResolution(const Scene& scene, double leastInterval);

class MotionSearch {
  public:
    /// The motion has been measured. A stretch that is not certified is given up when it is as short as leastInterval, or as
    /// contactInterval where an invalid pose is at its end. isStopped: MotionOptions::isStopped, may be
    /// empty.
    MotionSearch(Motion& motion, double leastInterval, double contactInterval,
                 std::function<bool()> isStopped = {});

    /// Looks at s2 first, then at the middle of the widest stretch that is not certified.
    MotionVerdict certify();

    /// Goes from the start to the end. certifiedTime() is how far it came.
    MotionVerdict goForward();

    MotionVerdict goForwardToReport(const ClearanceResolution&) { return goForward(); }

    double certifiedTime() const { return reached_.time; }
    MotionSample reached() const { return reached_; }
    bool isStartInvalid() const { return isStartInvalid_; }

    /// Looks at more poses of a motion that goForward found valid, where the clearance may be least, until
    /// the least clearance is known well enough. Returns a clearance that no pose is below.
    double refineLower(const ClearanceResolution& resolution);

    /// Looks at a motion, in place of certify or goForward, until its least clearance is known well enough or
    /// known to be `cap` but for the resolution. Returns a clearance that no pose is below. It may be more
    /// than the cap, and is at most 0 when the motion cannot be told from an invalid one. Returns nothing
    /// when a pose is invalid. isForReverse: the bound is to hold for the motion from s2 to s1, too.
    std::optional<double> leastClearance(double cap, const ClearanceResolution& resolution,
                                         bool isForReverse = false);

    /// The certified intervals up to certifiedTime() in order, divided until each interval's bound is at
    /// least `share` of the lesser room at its ends, or the interval is as short as the least interval.
    std::vector<MotionInterval> profile(double share);

    /// The pose that ended goForward, unless the motion is valid.
    double blockedTime() const { return blocked_.time; }
    bool leavesBounds() const { return blocked_.isOutOfBounds; }

  private:
    /// The length that two samples leave open between them, and the time at which to divide it.
    struct Stretch {
        double open;
        double time;
    };

    double spare(const MotionSample& from, const MotionSample& to) const;
    MotionInterval interval(const MotionSample& from, const MotionSample& to) const;
    bool isCertified(const MotionSample& from, const MotionSample& to) const {
        return interval(from, to).lower > 0;
    }
    double lowerBetween(const ZoneClearance& from, const ZoneClearance& to, double way) const;
    double dividingTime(const MotionSample& from, const MotionSample& to) const;
    double profiledTime(const MotionSample& from, const MotionSample& to) const;
    double wantedFor(double open) const;
    double wantedAtEnds() const;
    bool lookAtStart(double wanted);
    bool refine(double least, const ClearanceResolution& resolution);
    void keepOpen(const MotionInterval& added);
    Stretch stretchBefore(const MotionSample& next) const;
    void advance(const MotionSample& next);
    void stopBefore(const MotionSample& blocked, double stop);
    MotionVerdict verdictBefore(const std::vector<MotionSample>& ahead);

    Motion& motion_;
    double leastInterval_;
    double contactInterval_;
    std::function<bool()> isStopped_;
    MotionSample reached_;
    MotionSample blocked_;
    bool isStartInvalid_ = false;
    std::vector<MotionInterval> intervals_;  ///< a heap of the open ones in certify, else the certified ones
};

}  // namespace clearway::planning
