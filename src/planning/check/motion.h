// One motion of the part, and the clearances at its poses.
#pragma once

#include <ompl/base/SpaceInformation.h>

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "clearway/planning/motion_validator.h"
#include "clearway/scene_clearance.h"
#include "planning/check/posed_scene.h"
#include "planning/space/ompl_states.h"

namespace clearway::planning {

/// The last time of the interpolation; time 1 stands for s2.
constexpr double kJustBeforeEnd = 1 - 0x1p-53;

/// How closely the clearances along a motion are found.
enum class ClearanceDetail {
    kRough,  ///< up to the wanted length, within a tenth
    kTight,  ///< up to the wanted length, as tight as distances come
    kWhole,  ///< as tight, whatever length is wanted
};

/// The clearance at one pose of a motion, less the motion's floor.
struct MotionSample : Bounds {
    double time = 0;
    /// How far any point of the part may move while the pose stays valid: distance - margin - floor or, where
    /// obstacles are ignored, how far they stay ignored. A lower bound of at most 0 means that the pose is
    /// invalid.
    Bounds leeway;
    bool isOutOfBounds = false;

    MotionSample() { lower = leeway.lower = 0; }  ///< of a pose that no query was asked about
    bool isValid() const { return leeway.lower > 0 && !isOutOfBounds; }
};

/// The motion in exact arithmetic that OMPL's interpolation rounds: no point of the part moves further than
/// length() |b - a| between its times a and b. The scene and the states must outlive it.
class Motion {
  public:
    /// floor: clearance required on top of the margins.
    Motion(const PosedScene& posed, ClearanceDetail detail, double floor, const ob::State* s1,
           const ob::State* s2);

    /// Whether s2 is valid: by far the cheapest test of a motion. Throws what queries and callbacks throw.
    bool isEndValid();

    /// The same of the surfaces alone, where solids take longer.
    bool isEndClear();

    /// For a motion that a sweep certified: if s1 is known to be free, s2 is known to be, too.
    void followSide();

    /// Finds length() and slack(); call it before anything that follows. Throws OmplError when the
    /// motion has no finite bound, and what the callbacks throw.
    void measure();

    double length() const { return motion_.length; }

    /// Tighter than length(), but costs more than checking a short motion.
    double travel() const { return posed_.bound(s1_, s2_); }
    double floor() const { return floor_; }
    bool hasSolids() const { return posed_.clearance().hasSolids(); }
    bool areSidesKept() const { return posed_.clearance().areSidesKept(); }
    bool isStartWithinBounds() const { return posed_.si().satisfiesBounds(s1_); }
    bool isEndWithinBounds() const { return posed_.si().satisfiesBounds(s2_); }

    /// The distance between the states by the space's own metric.
    double distance() const { return posed_.si().distance(s1_, s2_); }

    /// Whether the part is free of all obstacles and within the bounds at a pose, and the sweep of the whole motion.
    /// The floor counts only in the sweep.
    bool isFreeAtStart();
    bool isFreeAt(double time);
    bool isClearAt(double time);  ///< of surfaces, within the bounds or not
    SceneSweep sweep(const SceneSweepOptions& options);

    /// Bounds of the motion's least clearance up to a cap, s2's besides the end of the interpolation. isForReverse: the
    /// lower bound is to hold for the motion from s2 to s1, too. Nothing when a pose is invalid.
    std::optional<LeastClearance> leastClearance(LeastClearanceOptions options, bool isForReverse);

    /// For a motion that a sweep found free of surfaces up to a time: finds up to when it also stays outside the
    /// solids.
    SolidsAlong stayOutsideSolids(double until, double leastInterval) const;

    bool isWithinBoundsAt(double time);

    /// Whether s2, which is within the bounds, is valid and keeps the floor, when a sweep says so of the interpolation to
    /// its end.
    bool isEndLikeInterpolation();

    /// Whether s2 is farther from the end of the interpolation than rounding takes it.
    bool jumpsAtEnd() const { return motion_.endJump > 0.125 * slack_; }

    /// Whether the motion is so short that sweeping it finds a blocked end as soon as a query there does.
    bool isShort() const;

    /// Whether some of three poses between the ends surely comes within the floor: by far cheaper than a sweep of a long motion.
    /// Ignores solids and bounds.
    bool isWithinFloorBetween();

    /// The time where the motion leaves the bounds: the last one found within, and one outside, closer than a length. Both
    /// are 1 when s2 is within.
    TimeSpan leavesBounds(double length);

    /// Forgets that a pose was found outside all solids: this carries over to other poses only while no surfaces
    /// touch in between.
    void forgetSide() { isOutside_ = false; }

    /// Looks at the poses that a report is about, where a sweep asked for no distance.
    void lookAtReported(double certifiedTime, double blockedTime);

    /// The longest move between two points of a profile, both of which have this clearance.
    double longestProfiled(double clearance) const;

    /// Bounds between two points of a profile need not be closer than this.
    double profileWidth() const;

    /// Finds startContact() and goalContact() to within a length, instead of from the poses looked at.
    void findContactSpans(double length);

    /// Samples of poses, valid or not, evenly spread over the motion after a time, its end included.
    std::vector<MotionSample> lookAhead(double from, int poses);

    /// Rounding allowance: an interval is certified when the clearances at both ends exceed the length of the motion
    /// between them by this.
    double slack() const { return slack_; }

    /// The next three functions look at a pose; lengths above `wanted` need not be found. All of them throw
    /// what queries and callbacks throw.
    MotionSample atStart(double wanted);
    MotionSample at(double time, double wanted);  ///< as interpolated; 0 < time < 1

    /// Looks at s2 itself. When s2 is valid, the sample holds what is certain both at s2 and at time 1 of the
    /// interpolation, which need not be s2: OMPL may leave out rotations of up to 1.6e-4 rad.
    MotionSample atEnd(double wanted);

    std::uint64_t queries() const { return queries_; }
    const PoseClearance& closest() const {
        return closest_;
    }  ///< of the poses looked at, floor not subtracted
    double closestTime() const { return closestTime_; }
    double leastUpper() const { return leastUpper_; }  ///< of the poses looked at, floor not subtracted

    /// The times from the first to the last of the poses looked at that are within the contact zone.
    const std::optional<TimeSpan>& startContact() const { return startContact_; }
    const std::optional<TimeSpan>& goalContact() const { return goalContact_; }

  private:
    MotionSample look(const ob::State* state, double time, double wanted, bool checksBounds);
    MotionSample sampleOf(double time, const PoseClearance& found) const;
    double findEndJump() const;
    PartMotion sweptMotion();
    PartMotion boundedMotion();
    std::optional<LeastClearance> leastWithoutClearance(LeastClearance found,
                                                        const LeastClearanceOptions& options);
    template <class IsTrue>
    TimeSpan change(TimeSpan span, double length, const IsTrue& isTrue);
    template <class IsIn>
    std::optional<TimeSpan> spanOf(double length, const IsIn& isIn);

    const PosedScene& posed_;
    ClearanceDetail detail_;
    double floor_;
    const ob::State* s1_;
    const ob::State* s2_;
    ScratchState scratch_;
    PartMotion motion_;
    double slack_ = 0;
    bool checksBoundsBetween_ = true;
    bool isEndKnown_ = false;  ///< s2 is valid
    bool isEndClear_ = false;  ///< s2 is clear of surfaces
    bool isOutside_ = false;  ///< no solid that always counts holds the part at one pose, so none does at any
    std::uint64_t queries_ = 0;
    PoseClearance closest_;
    std::optional<PoseClearance> atEnds_[2];  ///< of s1 and s2, which whole details ask for again and again
    double closestTime_ = 0;
    std::optional<double> leastTime_;  ///< of the pose that leastClearance found closest
    double leastUpper_ = std::numeric_limits<double>::infinity();
    std::optional<TimeSpan> startContact_, goalContact_;
};

}  // namespace clearway::planning
