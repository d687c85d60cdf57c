// One motion of the part, and how much room it has at a pose of it.
#pragma once

#include <ompl/base/SpaceInformation.h>

#include <array>
#include <cstdint>
#include <limits>
#include <optional>

#include "clearway/planning/displacement_bound.h"
#include "clearway/planning/motion_validator.h"
#include "clearway/planning/state_to_pose.h"
#include "planning/validity/scene_clearance.h"
#include "planning/validity/scratch_state.h"

namespace clearway::planning {

/// How clearances along a motion are told.
enum class ClearanceDetail {
    kRough,  ///< up to what is wanted, within a tenth
    kTight,  ///< up to what is wanted, as tight as distances come
    kWhole,  ///< as tight, and whatever is wanted
};

/// What a motion is looked at with; outlives it.
struct MotionTools {
    const ompl::base::SpaceInformation& si;
    const SceneClearance& clearance;
    const StateToPose& stateToPose;
    const DisplacementBound& bound;
    bool areBoundsConvex;  ///< of the space: what is between two states within them is within them
    ClearanceDetail detail;
    double floor = 0;  ///< asked of the part on top of the margin: clearances here are less this
};

struct MotionSample {
    double time = 0;
    /// How far any point of the part may move for sure, and the pose stays valid: the lower bound of
    /// distance - margin - floor, or where obstacles are ignored, how far they stay so. At most 0: it is
    /// invalid.
    double clearance = 0;
    bool isOutOfBounds = false;

    /// Upper bound of the same; infinite beyond what was wanted.
    double upper = std::numeric_limits<double>::infinity();

    double counting = 0;  ///< lower bound of distance - margin - floor, of the obstacles that count here
    double countingUpper = std::numeric_limits<double>::infinity();
    double always = 0;                            ///< lower bound, of those that count everywhere
    std::array<ZoneRoom, kMostZones> zones = {};  ///< of the others

    bool isValid() const { return clearance > 0 && !isOutOfBounds; }
};

/// The motion in exact arithmetic that OMPL's interpolation rounds: no point of the part moves further than
/// length() |b - a| between its times a and b.
class Motion {
  public:
    Motion(const MotionTools& tools, const ompl::base::State* s1, const ompl::base::State* s2);

    /// Whether s2 is valid: by far the cheapest thing to know of a motion. Throws what queries and callbacks
    /// throw.
    bool isEndValid();

    /// Finds length() and slack(), before anything that follows. Throws std::runtime_error when the motion
    /// has no finite bound, and what the callbacks throw.
    void measure();

    double length() const { return length_; }

    /// By the space's own metric.
    double distance() const { return tools_.si.distance(s1_, s2_); }

    /// What two clearances that certify an interval must have to spare, for poses are rounded.
    double slack() const { return slack_; }

    std::size_t zoneCount() const { return tools_.clearance.zoneCount(); }

    /// Lengths up to `wanted` are of interest. All of them throw what queries and callbacks throw.
    MotionSample atStart(double wanted);
    MotionSample at(double time, double wanted);  ///< as interpolated; 0 < time < 1

    /// s2 itself. When it is valid, the clearance is what is certain at s2 and at time 1 of the
    /// interpolation, which need not be s2: OMPL leaves out rotations below 1.6e-4 rad.
    MotionSample atEnd(double wanted);

    /// Known after atEnd: no point of the part moves further than this between the end of the interpolation
    /// and s2, nor between the poses of this motion and those of OMPL's motion from s2 to s1, but for
    /// rounding.
    double endJump() const { return endJump_; }

    std::uint64_t queries() const { return queries_; }
    const PoseClearance& closest() const { return closest_; }  ///< of the poses looked at
    double closestTime() const { return closestTime_; }
    /// From now on solids are looked at again: where the poses that follow are is not known from any other.
    void forgetOutside() { isOutside_ = false; }

    double leastUpper() const { return leastUpper_; }

    /// From the first to the last of the poses looked at that are within the contact zone.
    const std::optional<TimeSpan>& startContact() const { return startContact_; }
    const std::optional<TimeSpan>& goalContact() const { return goalContact_; }

  private:
    MotionSample look(const ompl::base::State* state, double time, double wanted, bool checksBounds);
    MotionSample sampleOf(double time, const PoseClearance& found) const;
    double findEndJump() const;

    MotionTools tools_;
    const ompl::base::State* s1_;
    const ompl::base::State* s2_;
    ScratchState scratch_;
    double length_ = 0;
    double slack_ = 0;
    double endJump_ = 0;
    bool checksBoundsBetween_ = true;
    bool isOutside_ = false;  ///< of the solids that always count: known at one pose, it holds at all
    std::uint64_t queries_ = 0;
    PoseClearance closest_;
    double closestTime_ = 0;
    double leastUpper_ = std::numeric_limits<double>::infinity();
    std::optional<TimeSpan> startContact_, goalContact_;
};

}  // namespace clearway::planning
