// Audits a whole path: how close it comes, where, between which meshes, and every motion that is not valid.
#pragma once

#include <ompl/geometric/PathGeometric.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "clearway/planning/motion_validator.h"

#pragma GCC visibility push(default)

namespace clearway::planning {

/// One motion of a path, from one of its states to the next one.
struct SegmentAudit {
    MotionReport motion;
    Pose X_environmentPart;  ///< the part at motion.closestTime, where motion.closest is
    double length = 0;       ///< straight way of the part's origin from end to end; environment units
    double turned = 0;       ///< angle between the ends, radians
    /// Names of the two meshes of motion.closest (a component's name, else its file's); empty when
    /// motion.closest has no two triangles.
    std::string partMesh, environmentMesh;

    /// Why the segment is not valid, as words after "is": "in collision: ...", with meshes and triangles.
    /// Empty when the segment is valid.
    std::string trouble;

    bool isValid() const { return motion.verdict == MotionVerdict::kValid; }
};

/// A pose of the path, and the clearance from there to the next point.
struct PathProfilePoint {
    std::size_t segment = 0;
    double time = 0;         ///< within the segment
    double travel = 0;       ///< from the path's start, see MotionReport::travel; environment units
    double clearance = 0;    ///< ProfilePoint::clearance
    double lowerToNext = 0;  ///< ProfilePoint::lowerToNext
};

struct PathAudit {
    /// In order. A path of one state has one segment, from the state to itself.
    std::vector<SegmentAudit> segments;
    std::vector<std::size_t> notValid;                ///< the segments that are not valid, in order
    MotionVerdict verdict = MotionVerdict::kInvalid;  ///< the worst of the segments' verdicts
    std::size_t closest = 0;  ///< the segment with the least clearance, of the poses looked at
    /// Bounds of the least distance - margin along the path. When the path is valid, they are as close as
    /// MotionValidator::report promises for a motion.
    double lowerClearance = 0, upperClearance = 0;
    double length = 0, turned = 0;  ///< summed over the segments
    std::uint64_t queries = 0;
    std::vector<PathProfilePoint> profile;  ///< in order; empty unless asked for

    bool isValid() const { return verdict == MotionVerdict::kValid; }
};

struct AuditOptions {
    bool profile = false;  ///< costs a few times as many queries
    /// For checkPath: called often; true leaves motions that are not judged yet undecided. audit() heeds what its
    /// validator was made with (MotionOptions::isStopped).
    std::function<bool()> isStopped = nullptr;
};

/// Judges every motion of the path, also those after a motion that is not valid. Throws std::invalid_argument
/// when the path has no state, or is in another space than the validator's. Nothing else is thrown: a motion
/// that cannot be judged is invalid, and its report says why.
PathAudit audit(const ompl::geometric::PathGeometric& path, const MotionValidator& validator,
                const AuditOptions& options = {});

}  // namespace clearway::planning

#pragma GCC visibility pop
