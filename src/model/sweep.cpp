// The public sweeps: check the caller's arguments and turn the trees' positions into ids.
#include "clearway/sweep.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "clearway/model.h"
#include "model/reach.h"
#include "query/sweep.h"

namespace clearway {

MotionPieces piecesOf(const RigidMotion& motion, const Model& part) {
    const double angle = motion.turn.norm();
    const Vector3 axis = angle > 0 ? Vector3(motion.turn / angle) : Vector3::UnitZ();
    const double radius = part.radiusAboutAxis(axis);
    return [=](double from, double to) {
        const double middle = from + 0.5 * (to - from), half = 0.5 * (to - from);
        MotionPiece piece;
        const Matrix3 turned = Eigen::AngleAxisd(middle * angle, axis).toRotationMatrix();
        piece.middle = {motion.start.rotation * turned, motion.start.translation + middle * motion.translation};
        piece.velocity = motion.translation;
        piece.angularVelocity = motion.start.rotation * motion.turn;
        piece.deviation = 0.5 * half * half * angle * angle * radius;
        return piece;
    };
}

SweepResult sweep(const Model& part, const Model& environment, const MotionPieces& motion, const SweepOptions& options,
                  Workspace& workspace) {
    Workspace::State& state = workspace.state();
    state.counters = {};
    SweepRequest request;
    request.goal = options.isForward ? SweepGoal::kForward : SweepGoal::kCertify;
    request.margin = options.margin;
    request.poseError = options.poseError;
    request.leastInterval = options.leastInterval;
    request.until = options.until;
    request.isContactAtEnd = options.isContactAtEnd;
    request.contactTime = options.contactTime;
    request.isStopped = &options.isStopped;
    request.mostEntries = kMostSweepEntries;
    const SweepAnswer answer = sweepTrees(part.tree(), environment.tree(), motion, request, state);
    SweepResult result;
    result.counters = state.counters;
    result.verdict = answer.isContact                         ? SweepVerdict::kContact
                     : answer.isUndecided || answer.isStopped ? SweepVerdict::kUndecided
                                                              : SweepVerdict::kCertified;
    if (answer.isContact) {
        result.contactTime = answer.contactTime;
        if (answer.isPair) {
            result.partTriangle = part.tree().triangleIds[answer.contact.part];
            result.environmentTriangle = environment.tree().triangleIds[answer.contact.environment];
        }
    }
    if (options.isForward) {
        result.certifiedUntil = answer.certifiedUntil;
    } else {
        result.certifiedUntil = result.verdict == SweepVerdict::kCertified ? options.until : 0;
    }
    return result;
}

LeastDistance leastDistance(const Model& part, const Model& environment, const MotionPieces& motion,
                            const LeastDistanceOptions& options, Workspace& workspace) {
    Workspace::State& state = workspace.state();
    state.counters = {};
    SweepRequest request;
    request.goal = SweepGoal::kLeastDistance;
    request.margin = options.margin;
    request.poseError = options.poseError;
    request.leastInterval = options.resolution.least;
    request.resolution = options.resolution;
    request.leastUpper = options.cap;
    request.isStopped = &options.isStopped;
    request.mostEntries = kMostSweepEntries;
    const SweepAnswer answer = sweepTrees(part.tree(), environment.tree(), motion, request, state);
    LeastDistance result;
    result.counters = state.counters;
    result.lower = answer.lower;
    if (answer.upper < options.cap) result.upper = answer.upper;
    result.time = answer.time;
    result.isStopped = answer.isStopped || answer.isUndecided;
    return result;
}

}  // namespace clearway
