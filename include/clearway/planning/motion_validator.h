// Certifies a motion along its whole length, pair by pair (see sweep.h), so that no pose between two checked ones is
// left to luck.
#pragma once

#include <ompl/base/MotionValidator.h>
#include <ompl/base/SpaceInformation.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "clearway/planning/shared_scene.h"
#include "clearway/query.h"
#include "clearway/scene.h"
#include "clearway/scene_clearance.h"

#pragma GCC visibility push(default)

namespace clearway::planning {

class PosedScene;

/// How MotionValidator judges motions.
struct MotionOptions {
    /// A motion is undecided where it cannot be certified in stretches that move the part by more than this:
    /// there the part comes closer to the margin than about half of this length. Environment units, finite,
    /// > 0. The default is 1e-5 of the diagonal of the part's box.
    std::optional<double> leastInterval;

    /// Called between queries and after at most 256 steps of a sweep, also from other threads; true leaves the
    /// motion undecided.
    std::function<bool()> isStopped;
};

/// Counts since the validator was made.
struct MotionCounters {
    std::uint64_t valid = 0;          ///< answered valid
    std::uint64_t invalid = 0;        ///< answered invalid, for whatever reason
    std::uint64_t undecided = 0;      ///< of these, without an invalid pose, but not certified throughout
    std::uint64_t invalidStarts = 0;  ///< of these, begun in an invalid state, against OMPL's contract
    std::uint64_t unusable =
        0;                      ///< of these, with a state without a pose, no bound, or a callback that threw
    std::uint64_t queries = 0;  ///< of distances, or whether one is within the margin
};

/// Times of a motion, from 0 to 1.
struct TimeSpan {
    double first = 0;  ///< at most `last`
    double last = 0;   ///< at most 1
};

/// The judgement of a motion.
enum class MotionVerdict {
    kValid,     ///< every pose of the motion is certified to be valid
    kInvalid,   ///< some pose is invalid, or the motion cannot be judged
    kUndecided  ///< no invalid pose is known, but not all poses could be certified: counts as invalid
};

/// Everything that MotionValidator reports about a motion.
struct MotionReport {
    MotionVerdict verdict = MotionVerdict::kInvalid;  ///< checkMotion's answer, and whether a pose is invalid
    /// All poses of [0, certifiedTime] are valid, unless the start is not. 1: all poses are.
    double certifiedTime = 0;
    /// Lower bound of the least distance - margin along the motion, over the obstacles that count;
    /// environment units.
    double lowerClearance = 0;
    /// Upper bound of the least distance - margin along the motion, over the obstacles that count;
    /// environment units.
    double upperClearance = 0;
    double closestTime = 0;  ///< of the closest of the poses looked at; 1 is s2 itself
    /// Both triangles, their components and points, and the obstacle at closestTime. No witness when that pose
    /// is farther than the environment's range, or no pose was looked at.
    SceneDistance closest;
    /// The times from the first to the last of the poses looked at that are within Scene::startContact, where
    /// obstacles are ignored.
    std::optional<TimeSpan> startContact;
    std::optional<TimeSpan> goalContact;  ///< the times within Scene::goalContact
    double travel = 0;       ///< no point of the part moves further along the motion; environment units
    double blockedTime = 1;  ///< of the pose that makes the motion invalid or undecided; 1 for a valid motion
    /// Why that pose is not valid, why the motion cannot be judged, or that it is undecided; nothing for a valid motion.
    WhyInvalid whyInvalid;
    std::uint64_t queries = 0;  ///< that the report took, but for whyInvalid
};

/// A pose of a motion, and the clearance from there to the next point. Lengths in environment units.
struct ProfilePoint {
    double time = 0;  ///< of the motion, 0 to 1
    /// Lower bound of distance - margin there, or 0 out of the bounds; above 0 exactly when the pose is valid.
    double clearance = 0;
    /// No pose from this one to the next one has less clearance. Where nothing is certified, this is the
    /// bound that holds for any pose: minus the largest margin.
    double lowerToNext = 0;
};

/// A motion with clearances along it.
struct MotionProfile {
    MotionReport report;               ///< of the whole motion
    std::vector<ProfilePoint> points;  ///< from time 0 to 1, in order; none when the motion cannot be judged
};

/// How MotionValidator::validUntil looks at a motion. Lengths in environment units, >= 0.
struct ForwardOptions {
    /// The certified poses end within this displacement of the pose that blocks, unless checkMotion's own bound is more.
    double within = 0;
    double more = 0;  ///< margins count as larger by this; see MotionValidator::keepsClearance
};

/// Certifies motions. When checkMotion returns true, s1, s2 and every pose of OMPL's own interpolation
/// between them are within the bounds, and there the part is farther from each obstacle that counts than the
/// obstacle's margin, and inside no solid.
///
/// A motion that touches the margin is invalid or undecided, which counts as invalid.
///
/// Any number of threads may use one validator: each has its own scratch and takes no lock. checkMotion
/// throws nothing: it answers a motion that cannot be judged as invalid, counts it, and logs the first one
/// through OMPL's console.
class MotionValidator : public ompl::base::MotionValidator {
  public:
    /// A Scene, or a SharedScene that others share. The bounds of a space with callbacks are checked at s1, at s2 and at each
    /// pose that is queried. Throws ArgumentError when si is null or has another space than OMPL's SE(3) and SE(2) and
    /// the scene no callbacks for it, with the name of the space (see displacementBound), a margin is negative or not finite,
    /// the part and an obstacle cannot be queried together, leastInterval is not finite and above 0, or the environment was
    /// built with a range shorter than the margin plus the least interval. Clearances beyond such a range count as the
    /// range's end.
    MotionValidator(const ompl::base::SpaceInformationPtr& si, SharedScene scene,
                    const MotionOptions& options = {});
    ~MotionValidator() override;

    /// Whether the motion is certified to be valid. Looks at the far end first.
    bool checkMotion(const ompl::base::State* s1, const ompl::base::State* s2) const override;

    /// Goes forward. On false lastValid.second is in [0, 1), all poses up to that time are certified, and
    /// lastValid.first, unless null, holds the state there, as it was interpolated. That state is within a hundred
    /// least intervals, in displacement, of the pose that blocks, or of one within rounding of contact or of a
    /// contact zone's boundary. Where motions are certified by clearances it is within two hundred. (OMPL may leave
    /// out rotations of up to 1.6e-4 rad: s2 may be farther from the end of the interpolation, and OMPL's motion from
    /// s1 to that state may be another one.) When s1 is invalid, lastValid is s1 at time 0. lastValid.first may be s1
    /// or s2. On true lastValid stays as it is.
    bool checkMotion(const ompl::base::State* s1, const ompl::base::State* s2,
                     std::pair<ompl::base::State*, double>& lastValid) const override;

    /// Returns the time, in [0, 1], up to which all poses are certified, as checkMotion goes forward; 1 for a valid
    /// motion. Counted as a motion checked.
    double validUntil(const ompl::base::State* s1, const ompl::base::State* s2,
                      const ForwardOptions& options) const;

    /// Reports a motion in full. The bounds of a valid motion's clearance are no farther apart than 1 % of it
    /// or, where that is more, 1e-3 of the part's diagonal, but then no farther than 10 % of it or the least
    /// interval; unless the environment's range ends before, or the motion comes within rounding of a contact zone's
    /// boundary without crossing it, so that which obstacles count is unknown. Not counted.
    MotionReport report(const ompl::base::State* s1, const ompl::base::State* s2) const;

    /// Reports a motion with clearances along it. Between two neighbouring points of the certified part the clearance
    /// is known to within a fifth of it, 1e-3 of the part's diagonal, or the least clearance of the motion, whichever
    /// is largest; or they are a least interval apart. They are no further apart than 2 % of the part's diagonal. A
    /// few points after the certified part show how the motion goes on.
    MotionProfile profile(const ompl::base::State* s1, const ompl::base::State* s2) const;

    /// Answers as checkMotion would if all margins were larger by `more`, in environment units. Counted as a
    /// motion checked. isStopped: like MotionOptions::isStopped, besides the validator's own. Throws
    /// ArgumentError when `more` is negative or not finite.
    virtual bool keepsClearance(const ompl::base::State* s1, const ompl::base::State* s2, double more,
                                const std::function<bool()>& isStopped = {}) const;

    /// Counts of all threads' questions to this validator.
    MotionCounters counters() const;

    /// MotionOptions::leastInterval or its default, in environment units.
    double leastInterval() const { return leastInterval_; }

    /// The scene that motions are judged in.
    const Scene& scene() const;

    /// The scene, to be shared with a checker or an objective.
    const SharedScene& shared() const;

    /// X_environmentPart at a state, by the validator's own callback.
    Pose pose(const ompl::base::State* state) const;

    /// Why a state is not valid, as ValidityChecker::whyInvalid says it.
    WhyInvalid whyInvalid(const ompl::base::State* state) const;

    /// The space whose interpolation makes the motions.
    const ompl::base::StateSpace& space() const { return *si_->getStateSpace(); }

  private:
    struct Outcome;
    struct Judging {
        bool forward = false;
        double floor = 0;                 ///< on top of the margins
        std::function<bool()> isStopped;  ///< besides the validator's own
        double within = 0;                ///< see ForwardOptions
    };
    Outcome judge(const ompl::base::State* s1, const ompl::base::State* s2, const Judging& judging) const;
    MotionReport report(const ompl::base::State* s1, const ompl::base::State* s2,
                        std::vector<ProfilePoint>* profile) const;
    WhyInvalid whyBlocked(const ompl::base::State* s1, const ompl::base::State* s2, double time) const;
    WhyInvalid whyUnusable(const ompl::base::State* s1, const ompl::base::State* s2,
                           const char* reason) const;
    double timeWithinBounds(const ompl::base::State* s1, const ompl::base::State* s2, double time) const;
    bool count(const Outcome& outcome) const;

    std::shared_ptr<const PosedScene> posed_;
    double leastInterval_;
    std::function<bool()> isStopped_;
};

}  // namespace clearway::planning

#pragma GCC visibility pop
