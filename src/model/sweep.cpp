// The public sweeps: check the caller's arguments and turn the trees' positions into ids.
#include "clearway/sweep.h"

#include <fmt/format.h>
#include <algorithm>
#include <limits>

#include "clearway/errors.h"
#include "clearway/model.h"
#include "core/number.h"
#include "model/arguments.h"
#include "model/model_data.h"
#include "model/query_range.h"
#include "query/sweep.h"

namespace clearway {

RigidMotion motionBetween(const Pose& from, const Pose& to) {
    const Eigen::AngleAxisd turn(Matrix3(from.rotation.transpose() * to.rotation));
    return {from, to.translation - from.translation, turn.angle() * turn.axis()};
}

MotionPieces piecesOf(const RigidMotion& motion, const Model& part) {
    const double angle = motion.rotation.norm();
    const Vector3 axis = angle > 0 ? Vector3(motion.rotation / angle) : Vector3::UnitZ();
    const double radius = part.radiusAboutAxis(axis);
    return [=](double from, double to) {
        const double middle = from + 0.5 * (to - from), half = 0.5 * (to - from);
        MotionPiece piece;
        const Matrix3 turned = Eigen::AngleAxisd(middle * angle, axis).toRotationMatrix();
        piece.middle = {motion.start.rotation * turned,
                        motion.start.translation + middle * motion.translation};
        piece.velocity = motion.translation;
        piece.angularVelocity = motion.start.rotation * motion.rotation;
        piece.deviationAcrossRotation = 0.5 * half * half * angle * angle * radius;
        return piece;
    };
}

namespace {

void requireInRange(double value, const char* name, bool isInRange, const char* range) {
    if (!isInRange) throw ArgumentError(fmt::format("{} is {:g}, expected {}", name, value, range));
}

TriangleIds triangleIdsOf(const Model& part, const Model& environment, const TrianglesAt& triangles) {
    return {treeOf(part).triangleId(triangles.part), treeOf(environment).triangleId(triangles.environment)};
}

/// Checks the arguments that both questions share, and begins the request.
SweepRequest beginSweep(const Model& part, const Model& environment, const MotionPieces& motion,
                        double margin, double poseError, const std::function<bool()>& isStopped,
                        Workspace::State& state) {
    if (!motion) throw ArgumentError("the motion is an empty function, expected one that returns pieces");
    requireSameWidth(part, environment);
    requireNotNegative("margin", margin);
    requireNotNegative("poseError", poseError);
    requireWithinCap(environment, margin + poseError);
    state.counters = {};
    SweepRequest request;
    request.margin = margin;
    request.poseError = poseError;
    request.isStopped = &isStopped;
    request.mostEntries = kMostSweepEntries;
    return request;
}

SweepAnswer answerTo(const SweepRequest& request, const Model& part, const Model& environment,
                     const MotionPieces& motion, Workspace::State& state) {
    if (!part.range() && !environment.range()) {
        return sweepTrees(treeOf(part), treeOf(environment), motion, request, state);
    }
    const MotionPieces withinRange = [&](double from, double to) {
        MotionPiece piece = motion(from, to);
        if (!piece.isForbidden) requireWithinRange(part, environment, piece.middle);
        return piece;
    };
    for (const double end : {request.from, request.until}) withinRange(end, end);
    return sweepTrees(treeOf(part), treeOf(environment), withinRange, request, state);
}

}  // namespace

SweepResult sweep(const Model& part, const Model& environment, const MotionPieces& motion,
                  const SweepOptions& options, Workspace& workspace) {
    Workspace::State& state = stateOf(workspace);
    const WorkspaceUse use(state);
    SweepRequest request =
        beginSweep(part, environment, motion, options.margin, options.poseError, options.isStopped, state);
    requireInRange(options.leastInterval, "leastInterval", options.leastInterval > 0, "a length above 0");
    request.leastInterval = options.leastInterval;
    requireInRange(options.from, "from", options.from >= 0 && options.from < 1, "a time from 0 to below 1");
    requireInRange(options.until, "until", options.until > options.from && options.until <= 1,
                   "a time after `from` and up to 1");
    requireNotNegative("contactTime", options.contactTime);
    request.goal = options.isForward ? SweepGoal::kForward : SweepGoal::kCertify;
    request.from = options.from;
    request.until = options.until;
    request.isContactAtEnd = options.isContactAtEnd;
    request.contactTime = options.contactTime;
    const SweepAnswer answer = answerTo(request, part, environment, motion, state);

    SweepResult result;
    result.counters = state.counters;
    result.verdict = answer.isContact                         ? SweepVerdict::kContact
                     : answer.isUndecided || answer.isStopped ? SweepVerdict::kUndecided
                                                              : SweepVerdict::kCertified;
    if (answer.isContact) {
        result.contactTime = answer.contactTime;
        if (answer.isPair) {
            result.contact = triangleIdsOf(part, environment, answer.contact);
        }
    }
    if (options.isForward) {
        result.certifiedUntil = answer.certifiedUntil;
    } else {
        result.certifiedUntil = result.verdict == SweepVerdict::kCertified ? options.until : options.from;
    }
    return result;
}

namespace {

/// Relative error of the distances that a search for a least distance begins with.
constexpr double kRoughSweepError = 0.3;

/// Finds a pair that is near at an end of the motion. Without one, a search meets hundreds of pairs, each nearer than those
/// before. Adds to the counters.
PairAtTime nearAtEnds(const Model& part, const Model& environment, const MotionPieces& motion, double margin,
                      double cap, Workspace& workspace) {
    PairAtTime known;
    known.clearance = cap;
    QueryCounters counters;
    for (const double end : {0.0, 1.0}) {
        const MotionPiece piece = motion(end, end);
        if (piece.counts != MotionPiece::Counts::kAtMiddle || piece.isForbidden) continue;
        DistanceOptions options;
        options.relativeError = kRoughSweepError;
        options.cap = std::max(0.0, known.clearance + margin);
        const DistanceResult found = distance(part, environment, piece.middle, options, workspace);
        counters += found.counters;
        if (found.upper - margin < known.clearance) {
            const Witnesses& witnesses = stateOf(workspace).witnesses;
            known = {found.upper - margin, end, witnesses.last};
        }
    }
    stateOf(workspace).counters = counters;
    return known;
}

}  // namespace

LeastDistance leastDistance(const Model& part, const Model& environment, const MotionPieces& motion,
                            const LeastDistanceOptions& options, Workspace& workspace) {
    Workspace::State& state = stateOf(workspace);
    const WorkspaceUse use(state);
    SweepRequest request =
        beginSweep(part, environment, motion, options.margin, options.poseError, options.isStopped, state);
    const ClearanceResolution& resolution = options.resolution;
    requireNotNegative("resolution.share", resolution.share);
    requireNotNegative("resolution.largestShare", resolution.largestShare);
    requireNotNegative("resolution.length", resolution.length);
    requireInRange(resolution.least, "resolution.least", resolution.least > 0, "a length above 0");
    request.leastInterval = resolution.least;
    const double cap = options.cap.value_or(std::numeric_limits<double>::infinity());
    requireInRange(cap, "cap", cap >= -options.margin, "a number of at least minus the margin");
    request.goal = SweepGoal::kLeastDistance;
    request.resolution = resolution;
    const double range = cappedByRange(environment, std::numeric_limits<double>::infinity());
    request.cap = std::min(cap, range - options.margin - options.poseError);
    request.known = nearAtEnds(part, environment, motion, options.margin, request.cap, workspace);
    const SweepAnswer answer = answerTo(request, part, environment, motion, state);

    LeastDistance result;
    result.counters = state.counters;
    result.lower = std::max(answer.lower, -options.margin);
    const auto& [clearance, time, triangles] = answer.nearest;
    if (clearance < request.cap) {
        const PairQuery query =
            preparePairQuery(treeOf(part), treeOf(environment), motion(time, time).middle);
        const ResolvedPair nearest = resolvePair(query, triangles);
        result.upper = std::min(clearance, nearest.upper / query.perMeshUnit - options.margin);
        result.nearest = NearestAlong{time, triangleIdsOf(part, environment, triangles),
                                      nearest.pointOnPart / query.perMeshUnit,
                                      nearest.pointOnEnvironment / query.perMeshUnit};
        state.witnesses.serve(part.id(), environment.id());
        state.witnesses.keep(query, triangles, nearest.pointOnPart, nearest.pointOnEnvironment);
    }
    result.isStopped = answer.isStopped || answer.isUndecided;
    if (result.isStopped) result.lower = -options.margin;
    result.lower = std::min(result.lower, result.upper);
    return result;
}

}  // namespace clearway
