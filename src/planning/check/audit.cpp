#include "clearway/planning/audit.h"

#include <algorithm>
#include <limits>

#include "clearway/errors.h"
#include "clearway/scene_clearance.h"
#include "core/parallel.h"
#include "planning/space/ompl_states.h"

namespace clearway::planning {
namespace {

/// Compares only properties that wrapper spaces (such as CForest's) forward.
bool isSameKind(const ob::StateSpace& a, const ob::StateSpace& b) {
    return a.getDimension() == b.getDimension() && a.getSerializationLength() == b.getSerializationLength();
}

void requireUsable(const og::PathGeometric& path, const MotionValidator& validator) {
    if (path.getStateCount() == 0) {
        throw ArgumentError("the path has no state, expected at least one");
    }
    const ob::StateSpace& space = *path.getSpaceInformation()->getStateSpace();
    if (isSameKind(space, validator.space())) return;
    throw ArgumentError("the path's states are of the space '" + space.getName() +
                        "', expected the validator's space '" + validator.space().getName() + "'");
}

/// Angle between two rotations.
double angleBetween(const Pose& a, const Pose& b) {
    return Eigen::Quaterniond(a.rotation).angularDistance(Eigen::Quaterniond(b.rotation));
}

/// The two ends of a segment.
struct Ends {
    const ob::State *from, *to;
};

Pose poseAt(const og::PathGeometric& path, const MotionValidator& validator, const Ends& ends, double time) {
    if (time == 0) return validator.pose(ends.from);
    if (time == 1) return validator.pose(ends.to);
    const ScratchState state(*path.getSpaceInformation());
    validator.space().interpolate(ends.from, ends.to, time, state.get());
    return validator.pose(state.get());
}

SegmentAudit describe(const og::PathGeometric& path, const MotionValidator& validator, const Ends& ends,
                      MotionReport motion) {
    SegmentAudit segment;
    segment.motion = std::move(motion);
    if (segment.motion.whyInvalid.isUnusable()) return segment;  // the states have no poses
    const Pose from = validator.pose(ends.from), to = validator.pose(ends.to);
    segment.length = (to.translation - from.translation).norm();
    segment.rotation = angleBetween(from, to);
    segment.X_environmentPart = poseAt(path, validator, ends, segment.motion.closestTime);
    const MeshNames names = distinctMeshNames(validator.scene(), segment.motion.closest);
    segment.partMesh = names.part;
    segment.environmentMesh = names.environment;
    return segment;
}

/// Returns the worse verdict: invalid is worse than undecided.
MotionVerdict worse(MotionVerdict a, MotionVerdict b) {
    for (const MotionVerdict verdict : {MotionVerdict::kInvalid, MotionVerdict::kUndecided}) {
        if (a == verdict || b == verdict) return verdict;
    }
    return MotionVerdict::kValid;
}

void add(PathAudit& audit, SegmentAudit segment) {
    const MotionReport& motion = segment.motion;
    const std::size_t index = audit.segments.size();
    if (!segment.isValid()) audit.notValid.push_back(index);
    audit.verdict = worse(audit.verdict, motion.verdict);
    audit.lowerClearance = std::min(audit.lowerClearance, motion.lowerClearance);
    if (motion.upperClearance < audit.upperClearance) audit.closest = index;
    audit.upperClearance = std::min(audit.upperClearance, motion.upperClearance);
    audit.length += segment.length;
    audit.rotation += segment.rotation;
    audit.queries += motion.queries;
    audit.segments.push_back(std::move(segment));
}

/// The end of one segment is the beginning of the next one. That point stands in the profile once, as the
/// next segment's.
void addProfile(PathAudit& audit, const std::vector<ProfilePoint>& points, double travelBefore,
                double travel) {
    const std::size_t segment = audit.segments.size();
    if (!points.empty() && !audit.profile.empty() && audit.profile.back().time == 1) audit.profile.pop_back();
    for (const ProfilePoint& point : points) {
        audit.profile.push_back(
            {segment, point.time, travelBefore + point.time * travel, point.clearance, point.lowerToNext});
    }
}

}  // namespace

PathAudit audit(const og::PathGeometric& path, const MotionValidator& validator,
                const AuditOptions& options) {
    requireUsable(path, validator);
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const auto count = static_cast<unsigned int>(path.getStateCount());
    const auto endsOf = [&](std::size_t segment) {
        const auto from = static_cast<unsigned int>(segment);
        return Ends{path.getState(from), path.getState(std::min(from + 1, count - 1))};
    };
    const auto requireGoingOn = [&] {
        if (options.isStopped && options.isStopped()) throw AuditStopped("the audit was stopped");
    };
    std::vector<MotionProfile> found(std::max(count - 1, 1u));
    // Without a warm start a motion's report is the same on any thread.
    const auto look = [&](std::size_t i) {
        requireGoingOn();
        const SceneClearance::ColdStart cold(*validator.shared().clearance());
        const Ends ends = endsOf(i);
        if (options.profile) {
            found[i] = validator.profile(ends.from, ends.to);
        } else {
            found[i].report = validator.report(ends.from, ends.to);
        }
    };
    // Callbacks of the user's own may be for one thread.
    if (validator.shared().stateToPose()) {
        for (std::size_t i = 0; i < found.size(); ++i) look(i);
    } else {
        forEachInParallel(found.size(), look);
    }
    requireGoingOn();  // a motion that was stopped is undecided for no other reason

    PathAudit result;
    result.verdict = MotionVerdict::kValid;
    result.lowerClearance = result.upperClearance = kInfinity;
    double travelled = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const double travel = found[i].report.travel;
        addProfile(result, found[i].points, travelled, travel);
        add(result, describe(path, validator, endsOf(i), std::move(found[i].report)));
        travelled += travel;
    }
    return result;
}

}  // namespace clearway::planning
