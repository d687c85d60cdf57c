// Which poses of a motion to look at, until it is certified or something is in the way.
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <vector>

#include "clearway/planning/motion_validator.h"
#include "planning/motion/motion.h"

namespace clearway::planning {

/// From one sample to the next one along the motion. lower: no pose between them has less clearance from
/// what counts there; above 0 the interval is certified.
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

/// 1e-5 of the diagonal of the part's box, of the environment's when the part is a point.
double defaultLeastInterval(const Scene& scene);

/// How well least clearances are told to users: 1 % or, where that is more, 1e-3 of the part's diagonal, but
/// no worse than 10 % or leastInterval.
ClearanceResolution usualResolution(const Scene& scene, double leastInterval);

class MotionSearch {
  public:
    /// leastInterval, contactInterval: what is not certified is given up when it is this short; the latter
    /// where an invalid pose is at its end. isStopped, unless empty: of MotionOptions.
    MotionSearch(Motion& motion, double leastInterval, double contactInterval,
                 std::function<bool()> isStopped = {});

    /// The far end first, then the middle of the widest stretch that is not certified.
    MotionVerdict certify();

    /// From the start to the end. certifiedTime() tells how far it came.
    MotionVerdict goForward();

    double certifiedTime() const { return reached_.time; }
    const MotionSample& reached() const { return reached_; }
    bool isStartInvalid() const { return isStartInvalid_; }

    /// Looks at more poses of a motion that goForward found valid, where the clearance may be least, until
    /// its least over all intervals is known well enough. Returns that: no pose has less.
    double refineLower(const ClearanceResolution& resolution);

    /// Looks at a motion not looked at before until its least clearance is known well enough, or is known to
    /// be `cap` but for the resolution. Returns a clearance that no pose is below; it may be more than the
    /// cap, and is at most 0 when the motion cannot be told from an invalid one. Nothing when a pose is
    /// invalid.
    std::optional<double> leastClearance(double cap, const ClearanceResolution& resolution);

    /// The certified intervals up to certifiedTime() in order, divided until each one's bound is at least
    /// this share of the lesser clearance at its ends, or it is as short as the least interval.
    std::vector<MotionInterval> profile(double share);

    /// So many poses evenly spread over what follows certifiedTime(), its end included, valid or not.
    std::vector<MotionSample> lookAhead(int poses);

    /// The pose that ended goForward, unless the motion is valid.
    const MotionSample& blocked() const { return blocked_; }

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
    double lowerBetween(const ZoneRoom& from, const ZoneRoom& to, double way) const;
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
    std::vector<MotionInterval> intervals_;  ///< certify: a heap of the open ones; else the certified ones
};

}  // namespace clearway::planning
