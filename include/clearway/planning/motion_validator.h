// Certifies a motion along its whole length: no pose between two checked ones is left to luck.
// Source: Schwarzer, Saha, Latombe, Adaptive Dynamic Collision Checking for Single and Multiple Articulated
// Robots in Complex Environments, 2005.
#pragma once

#include <ompl/base/MotionValidator.h>
#include <ompl/base/SpaceInformation.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "clearway/planning/displacement_bound.h"
#include "clearway/planning/state_to_pose.h"
#include "clearway/query.h"
#include "clearway/scene.h"

namespace clearway::planning {

class Motion;
class SceneClearance;

struct MotionOptions {
    /// What is not certified in stretches that move the part by more than this is given up as undecided:
    /// there the part comes closer to the margin than about half of it. Environment units, finite, > 0. The
    /// default is 1e-5 of the diagonal of the part's box.
    std::optional<double> leastInterval;

    /// Asked between queries, also from other threads; true leaves the motion undecided. One that slides
    /// along a face may take seconds.
    std::function<bool()> isStopped;
};

/// Of all motions since the validator was made.
struct MotionCounters {
    std::uint64_t valid = 0;
    std::uint64_t invalid = 0;        ///< answered invalid, for whatever reason
    std::uint64_t undecided = 0;      ///< of these: no invalid pose was found, but not all are certified
    std::uint64_t invalidStarts = 0;  ///< of these: began in an invalid state, against OMPL's contract
    std::uint64_t unusable = 0;  ///< of these: a state without a pose, no bound, or a callback that threw
    std::uint64_t queries = 0;   ///< of distances, or whether one is within the margin
};

/// Of a motion from 0 to 1.
struct TimeSpan {
    double first = 0, last = 0;
};

enum class MotionVerdict { kValid, kInvalid, kUndecided };

struct MotionReport {
    MotionVerdict verdict = MotionVerdict::kInvalid;
    double certifiedTime =
        0;  ///< all poses of [0, certifiedTime] are valid, unless the start is not; 1: all are
    /// Of the least of distance - margin along the motion, of obstacles that count. Environment units.
    double lowerClearance = 0;
    double upperClearance = 0;
    double closestTime = 0;  ///< of the pose that is closest, of those looked at; 1 is s2 itself
    /// There: both triangles, their components and points, and the obstacle. Its ids are -1 when the pose is
    /// farther than the environment's reach tells, or no pose was looked at.
    SceneDistance closest;
    /// From the first to the last of the poses looked at that are within the scene's contact zones, where
    /// obstacles are ignored.
    std::optional<TimeSpan> startContact, goalContact;
    double travel = 0;          ///< no point of the part moves further along the motion
    double blockedTime = 1;     ///< of a motion that is not valid: of the pose that is invalid or undecided
    bool leavesBounds = false;  ///< that pose is invalid for being out of the space's bounds
    std::uint64_t queries = 0;
    std::string problem;  ///< why the motion cannot be judged; empty when it can
};

/// A pose of a motion and what is known from there to the next one.
struct ProfilePoint {
    double time = 0;
    double clearance = 0;  ///< lower bound of distance - margin there; above 0 when the pose is valid
    /// No pose from this one to the next one has less. Where nothing is certified, what holds of any pose.
    double lowerToNext = 0;
};

struct MotionProfile {
    MotionReport report;
    std::vector<ProfilePoint> points;  ///< from time 0 to 1, in order; none when it cannot be judged
};

/// checkMotion true means: every pose of OMPL's own interpolation between the two states, s1 and s2 itself
/// are within the bounds, and the part is farther from each obstacle that counts there than its margin, and
/// inside no solid.
///
/// An interval is certified when the clearances at its ends add up to more than the part can move between
/// them. A valid motion costs about ds / clearance queries, summed along it; a motion that touches the margin
/// is invalid or undecided, which counts as invalid.
///
/// Any number of threads may use one validator: each has its own scratch and takes no lock. Nothing is
/// thrown out of checkMotion: what cannot be judged is invalid, counted, and logged once through OMPL's
/// console.
class MotionValidator : public ompl::base::MotionValidator {
  public:
    /// For OMPL's SE(3) and SE(2). Throws std::invalid_argument that names the space when si has another one
    /// (see displacementBound), a margin is negative or not finite, the part and an obstacle cannot be
    /// queried together, leastInterval is no length, or the environment was built with a reach that ends
    /// before the margin and the least interval on top. Where such a reach ends, clearances count as no more.
    MotionValidator(const ompl::base::SpaceInformationPtr& si, Scene scene,
                    const MotionOptions& options = {});

    /// For any space. The bounds of the space are checked at s1, at s2 and at each pose that is queried.
    /// Throws likewise, and when a callback is empty. What the poses of interpolated states are off those
    /// that the bound is meant for must be rounding: at most 2^-47 of the lengths involved.
    MotionValidator(const ompl::base::SpaceInformationPtr& si, Scene scene, StateToPose stateToPose,
                    DisplacementBound bound, const MotionOptions& options = {});

    ~MotionValidator() override;

    /// The far end is looked at first, then the middle of the widest stretch that is not certified.
    bool checkMotion(const ompl::base::State* s1, const ompl::base::State* s2) const override;

    /// Goes forward. On false lastValid.second is in [0, 1), all poses up to it are certified, and
    /// lastValid.first, unless null, holds the state there, which was looked at as interpolated. It is within
    /// a hundred least intervals of what blocks, in displacement. (From s1 to that state may be another
    /// motion: OMPL leaves out turns below 1.6e-4 rad.) When s1 is invalid, it is s1, at 0. lastValid.first
    /// may be s1 or s2. On true both stay.
    bool checkMotion(const ompl::base::State* s1, const ompl::base::State* s2,
                     std::pair<ompl::base::State*, double>& lastValid) const override;

    /// All there is to know of a motion. The bounds of a valid motion's clearance are no farther apart than
    /// 1 % of it or, where that is more, 1e-3 of the part's diagonal, but then no farther than 10 % of it or
    /// the least interval; unless the environment's reach ends before. Not counted.
    MotionReport report(const ompl::base::State* s1, const ompl::base::State* s2) const;

    /// The same, and clearances along the motion. As far as it is certified they stand so close that four
    /// fifths of them are certain from each to the next one, or a least interval apart; beyond there are a
    /// few, so that it is known how the motion goes on.
    MotionProfile profile(const ompl::base::State* s1, const ompl::base::State* s2) const;

    /// What checkMotion would answer if all margins were larger by `more`, in environment units. Counted as a
    /// motion checked. isStopped: as MotionOptions has it, besides the validator's own. Throws
    /// std::invalid_argument when `more` is negative or not finite.
    virtual bool keepsClearance(const ompl::base::State* s1, const ompl::base::State* s2, double more,
                                const std::function<bool()>& isStopped = {}) const;

    MotionCounters counters() const;
    double leastInterval() const { return leastInterval_; }
    const Scene& scene() const;

    /// X_environmentPart at a state, by the validator's own callback.
    Pose pose(const ompl::base::State* state) const { return stateToPose_(state); }

    /// Why a state is not valid, as ValidityChecker::whyInvalid.
    std::string whyInvalid(const ompl::base::State* state) const;

    const ompl::base::StateSpace& space() const { return *si_->getStateSpace(); }

  private:
    struct Outcome;
    struct Judging {
        bool forward = false;
        double floor = 0;                 ///< on top of the margins
        std::function<bool()> isStopped;  ///< besides the validator's own
    };
    Outcome judge(const ompl::base::State* s1, const ompl::base::State* s2, const Judging& judging) const;
    MotionReport report(const ompl::base::State* s1, const ompl::base::State* s2,
                        std::vector<ProfilePoint>* profile) const;
    double timeWithinBounds(const ompl::base::State* s1, const ompl::base::State* s2, double time) const;
    bool count(const Outcome& outcome) const;
    void logOnce(const std::string& problem) const;
    Motion motion(const ompl::base::State* s1, const ompl::base::State* s2, bool isReported,
                  double floor) const;

    std::shared_ptr<const SceneClearance> clearance_;
    StateToPose stateToPose_;
    DisplacementBound bound_;
    double leastInterval_;
    std::function<bool()> isStopped_;
    bool areBoundsConvex_ = false;
    mutable std::atomic<std::uint64_t> validMotions_{0}, invalidMotions_{0}, undecided_{0}, invalidStarts_{0},
        unusable_{0}, queries_{0};
    mutable std::atomic<bool> isLogged_{false};
};

}  // namespace clearway::planning
