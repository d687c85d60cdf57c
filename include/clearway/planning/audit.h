// Looks at a whole path again: how close it comes, where, between which meshes, and all that is not valid.
#pragma once

#include <ompl/geometric/PathGeometric.h>

#include <cstdint>
#include <string>
#include <vector>

#include "clearway/planning/motion_validator.h"

namespace clearway::planning {

/// One motion of a path, from one of its states to the next one.
struct SegmentAudit {
    MotionReport motion;
    Pose X_environmentPart;  ///< where motion.closest is: at motion.closestTime
    double length = 0;       ///< straight from end to end, of the part's origin; environment units
    double turned = 0;       ///< radians, from end to end
    /// Names of the two meshes closest there (a component's, else its file's); empty when motion.closest is
    /// of no two triangles.
    std::string partMesh, environmentMesh;

    /// Why the segment is not valid, as words after "is": "in collision: ...", with meshes and triangles.
    /// Empty when it is valid.
    std::string trouble;

    bool isValid() const { return motion.verdict == MotionVerdict::kValid; }
};

/// A pose of the path, and what is known from there to the next one.
struct PathProfilePoint {
    std::size_t segment = 0;
    double time = 0;       ///< within the segment
    double travel = 0;     ///< from the path's start, see MotionReport::travel; environment units
    double clearance = 0;  ///< as ProfilePoint has it
    double lowerToNext = 0;
};

struct PathAudit {
    /// In order. A path of one state has one, from the state to itself.
    std::vector<SegmentAudit> segments;
    std::vector<std::size_t> notValid;                ///< which of them are not valid, in order
    MotionVerdict verdict = MotionVerdict::kInvalid;  ///< of the path: the worst of its segments'
    std::size_t closest = 0;  ///< the segment whose clearance is least, of the poses looked at
    /// Of the least of distance - margin along the path; as wide as MotionValidator::report says of motions
    /// when it is valid.
    double lowerClearance = 0, upperClearance = 0;
    double length = 0, turned = 0;  ///< summed over the segments
    std::uint64_t queries = 0;
    std::vector<PathProfilePoint> profile;  ///< in order; empty unless asked for

    bool isValid() const { return verdict == MotionVerdict::kValid; }
};

struct AuditOptions {
    bool profile = false;  ///< costs a few times as many queries
};

/// Judges every motion of the path, also behind those that are not valid. Throws std::invalid_argument when
/// the path has no state, or is one of another space than the validator's. Nothing else is thrown: a motion
/// that cannot be judged is invalid, and its report says why.
PathAudit audit(const ompl::geometric::PathGeometric& path, const MotionValidator& validator,
                const AuditOptions& options = {});

}  // namespace clearway::planning
