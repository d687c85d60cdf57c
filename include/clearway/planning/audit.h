// Audits a whole path: how close it comes, where, between which meshes, and every motion that is not valid.
#pragma once

#include <ompl/geometric/PathGeometric.h>

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "clearway/planning/motion_validator.h"

#pragma GCC visibility push(default)

namespace clearway::planning {

/// One motion of a path, from one of its states to the next one.
struct SegmentAudit {
    MotionReport motion;     ///< the validator's report of the motion
    Pose X_environmentPart;  ///< the part at motion.closestTime, where motion.closest is
    double length = 0;       ///< straight distance of the part's origin from end to end; environment units
    double rotation = 0;     ///< angle between the ends, radians
    /// Name of the part's mesh in motion.closest: a component's name, else its file's. Empty when
    /// motion.closest has no two triangles.
    std::string partMesh;
    std::string environmentMesh;  ///< name of the obstacle's mesh in motion.closest, or empty

    /// Whether the motion is certified to be valid.
    bool isValid() const { return motion.verdict == MotionVerdict::kValid; }
};

/// A pose of the path, and the clearance from there to the next point.
struct PathProfilePoint {
    std::size_t segment = 0;  ///< index into PathAudit::segments
    double time = 0;          ///< within the segment, 0 to 1
    double travel = 0;        ///< from the path's start, see MotionReport::travel; environment units
    double clearance = 0;     ///< ProfilePoint::clearance
    double lowerToNext = 0;   ///< ProfilePoint::lowerToNext
};

/// The judgement of a whole path.
struct PathAudit {
    /// One for each motion, in order. A path of one state has one segment, from the state to itself.
    std::vector<SegmentAudit> segments;
    std::vector<std::size_t> notValid;                ///< the segments that are not valid, in order
    MotionVerdict verdict = MotionVerdict::kInvalid;  ///< the worst of the segments' verdicts
    std::size_t closest = 0;  ///< the segment with the least clearance, of the poses looked at
    /// Lower bound of the least distance - margin along the path; environment units. When the path is valid,
    /// the two bounds are as close as MotionValidator::report promises for a motion.
    double lowerClearance = 0;
    double upperClearance = 0;              ///< upper bound of the least distance - margin along the path
    double length = 0;                      ///< SegmentAudit::length, summed over the segments
    double rotation = 0;                    ///< SegmentAudit::rotation, summed over the segments
    std::uint64_t queries = 0;              ///< MotionReport::queries, summed over the segments
    std::vector<PathProfilePoint> profile;  ///< in order; empty unless asked for

    /// Whether every motion of the path is certified to be valid.
    bool isValid() const { return verdict == MotionVerdict::kValid; }
};

/// Options of audit(): with `profile`, it also fills PathAudit::profile.
struct AuditOptions {
    bool profile = false;  ///< costs a few times as many queries
    /// Called before each motion, and by checkPath also within motions, from several threads. True ends the audit: it throws
    /// AuditStopped.
    std::function<bool()> isStopped = nullptr;
};

/// Thrown when AuditOptions::isStopped returns true.
class AuditStopped : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Judges every motion of the path, also those after a motion that is not valid, each without a warm start. In OMPL's SE(3) and
/// SE(2) motions run on as many threads as oneTBB gives the caller. Throws ArgumentError
/// when the path has no state, or is in another space than the validator's, and AuditStopped. Nothing else is thrown: a motion
/// that cannot be judged is invalid, and its report says why.
PathAudit audit(const ompl::geometric::PathGeometric& path, const MotionValidator& validator,
                const AuditOptions& options = {});

}  // namespace clearway::planning

#pragma GCC visibility pop
