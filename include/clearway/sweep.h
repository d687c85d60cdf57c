// Two queries about a part in motion: whether it keeps more than a margin from an environment all along, and its
// least distance.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>

#include "clearway/query.h"
#include "clearway/types.h"

#pragma GCC visibility push(default)

namespace clearway {

/// A straight translation with a rotation at a constant rate: at time t from 0 to 1 the pose is x -> R exp(t [rotation])
/// x + p + t translation, where (R, p) is the start.
struct RigidMotion {
    Pose start;           ///< X_environmentPart at time 0
    Vector3 translation;  ///< of the origin of the part's coordinates; environment's frame
    Vector3 rotation;     ///< an axis fixed in the part, times the angle in radians; part's frame
};

/// The motion from one pose to another, straight and with the shorter rotation. Between orientations that are 180
/// degrees apart it is one of the two rotations.
RigidMotion motionBetween(const Pose& from, const Pose& to);

/// A motion over an interval of time, as seen from the middle of the interval.
struct MotionPiece {
    Pose middle;       ///< X_environmentPart
    Vector3 velocity;  ///< of the origin of the part's coordinates, per unit of time; environment's frame
    Vector3 angularVelocity;  ///< radians per unit of time; environment's frame

    /// Bound on the deviation from the linearised motion, in which all points move at their velocities in the middle.
    /// At a share x of the half interval from the middle, points are off by at most x (deviation +
    /// deviationAcrossRotation). The second length acts only perpendicularly to the angular velocity (the sagitta of a
    /// circle). Environment units.
    double deviation = 0;
    double deviationAcrossRotation = 0;  ///< the second of these lengths; environment units

    /// Where in the interval contact counts. A motion may ignore an environment for a while.
    enum class Counts {
        kAtMiddle,     ///< in the middle, and perhaps not everywhere else
        kNotAtMiddle,  ///< not in the middle, but perhaps elsewhere
        kNowhere       ///< nowhere in the interval
    };
    Counts counts = Counts::kAtMiddle;  ///< where in the interval contact counts

    /// The pose in the middle is not allowed, wherever the environment is.
    bool isForbidden = false;
};

/// Returns the piece of a motion over the interval [from, to]. The pose at a time must not depend on the interval.
using MotionPieces = std::function<MotionPiece(double from, double to)>;

/// The pieces of a rigid motion of a part. Their poses are off the motion by a few 2^-53 of the lengths of start and
/// translation and of the rotation's angle times the part's radius about its origin; SweepOptions::poseError can
/// cover that.
MotionPieces piecesOf(const RigidMotion& motion, const Model& part);

/// The answer of a sweep.
enum class SweepVerdict {
    kCertified,  ///< the part keeps more than the margin at all times asked about
    kContact,    ///< at some time the part comes as close as the margin, or the motion forbids its pose
    kUndecided   ///< neither is known: too close to the margin to tell, or stopped
};

/// The question of a sweep, and how closely it is to be answered.
struct SweepOptions {
    double margin = 0;  ///< distances up to this count as contact; environment units, >= 0

    /// A sweep is undecided where it cannot be certified in pieces that move a point of the part by more than this.
    /// There the part comes closer to the margin than about half of this length. Environment units, > 0.
    double leastInterval = 1e-6;

    /// Poses may be off the motion by this length, because they are rounded. The sweep certifies margin + poseError;
    /// contact is judged by the margin alone. Environment units, >= 0.
    double poseError = 0;

    /// Whether to find how far the motion is certified from its start, and not only whether all of it is.
    bool isForward = false;

    /// With isForward: the search for earlier contacts ends once the certified part of the motion ends within this
    /// time before the contact found. Time of the motion, finite, >= 0.
    double contactTime = 1e-3;

    double from = 0;   ///< earlier times do not matter; 0 <= from < until
    double until = 1;  ///< later times do not matter; at most 1
    /// The pose at `until` is known to be in contact with something, perhaps with another environment: going forward, no
    /// contact is looked for within contactTime before it.
    bool isContactAtEnd = false;

    /// Asked after at most 256 steps; true ends the sweep as undecided.
    std::function<bool()> isStopped;
};

/// A pair of triangles, by their positions in the meshes as loaded, before cleaning.
struct TriangleIds {
    std::int64_t part = 0;         ///< in the part's mesh
    std::int64_t environment = 0;  ///< in the environment's mesh
};

/// The answer of sweep().
struct SweepResult {
    SweepVerdict verdict = SweepVerdict::kUndecided;  ///< about all times from SweepOptions::from to `until`

    /// At all times from SweepOptions::from to this one the distance is larger than margin + poseError. Found when going
    /// forward; otherwise `until` for a certified motion and `from` for others.
    double certifiedUntil = 0;

    std::optional<double> contactTime;  ///< of a pose in contact, or forbidden; none without contact
    /// A pair of triangles in contact then; none without contact, and for a forbidden pose.
    std::optional<TriangleIds> contact;
    QueryCounters counters;  ///< the work that the answer took
};

/// Certifies a motion of the part: a pair of volumes is certified for as long as their gap exceeds their approach
/// speed times the time. An environment that was built for a range must hold all poses of the motion within it; only
/// the poses at `from`, at `until` and in the middles of pieces are checked. Throws ArgumentError as
/// distance() does at these poses, and when an option is out of its range or a piece of the motion is not finite.
SweepResult sweep(const Model& part, const Model& environment, const MotionPieces& motion,
                  const SweepOptions& options, Workspace& workspace);

/// How closely a least distance must be known: within `share` of it or, where that is more, within `length`, but
/// never worse than `largestShare` of it or, where that is more, `least`.
struct ClearanceResolution {
    double share;         ///< dimensionless, >= 0
    double largestShare;  ///< dimensionless, >= 0
    double length;        ///< environment units, >= 0
    double least;         ///< environment units, > 0

    /// The width that the bounds of a clearance may have; environment units.
    double of(double clearance) const {
        return std::max({share * clearance, std::min(largestShare * clearance, length), least});
    }
};

/// The question of leastDistance(), and how closely it is to be answered.
struct LeastDistanceOptions {
    double margin = 0;     ///< the resolution is that of the distance less this; environment units, >= 0
    double poseError = 0;  ///< how far poses may be off the motion, because they are rounded; >= 0

    std::optional<double> cap;  ///< distances less the margin from here on do not matter; without it all do
    ClearanceResolution resolution{1e-2, 0.1, 0, 1e-6};  ///< how close the two bounds must be
    std::function<bool()> isStopped;  ///< asked after at most 256 steps; true ends the search
};

/// A pose of a motion, and two triangles that are nearest to each other there.
struct NearestAlong {
    double time = 0;             ///< of the motion
    TriangleIds triangles;       ///< the two triangles
    Vector3 pointOnPart;         ///< the point of the part's triangle; environment's frame
    Vector3 pointOnEnvironment;  ///< the point of the environment's triangle; environment's frame
};

/// The answer of leastDistance(): lower <= the least distance along the motion less the margin <= upper.
/// Lengths in environment units.
struct LeastDistance {
    double lower = 0;                                        ///< minus the margin where nothing is known
    double upper = std::numeric_limits<double>::infinity();  ///< infinite beyond the cap
    std::optional<NearestAlong> nearest;                     ///< the witness of `upper`; none beyond the cap
    bool isStopped = false;  ///< the search ended early; lower is then minus the margin
    QueryCounters counters;  ///< the work that the answer took
};

/// Finds the least distance along a motion. Ends early when some distance less the margin is not above the
/// resolution: then only upper is known. If a piece is forbidden, neither bound is known: lower is minus the margin,
/// upper is infinite. Throws as sweep() does.
LeastDistance leastDistance(const Model& part, const Model& environment, const MotionPieces& motion,
                            const LeastDistanceOptions& options, Workspace& workspace);

}  // namespace clearway

#pragma GCC visibility pop
