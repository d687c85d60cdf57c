// The scene's answers about motions: every obstacle is swept past, with its margin and as far as contact zones let it count.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "clearway/errors.h"
#include "core/number.h"
#include "scene/contact_zones.h"
#include "scene/scene_scratch.h"

namespace clearway {
namespace {

std::optional<double> earlierOf(const std::optional<double>& a, const std::optional<double>& b) {
    return a && (!b || *a < *b) ? a : b;
}

}  // namespace

/// Upper bound of any point's displacement from the middle of a piece to either end, environment units.
/// PartMotion::length is a looser bound for a rotating part far from its own origin.
double SceneClearance::movedInHalf(const MotionPiece& piece, double halfTime) const {
    const Box& box = scene_.part.box();
    const Vector3 centre = piece.middle.rotation * box.center();
    const Vector3 velocity = piece.velocity + piece.angularVelocity.cross(centre);
    const double aboutCentre = 0.5 * box.diagonal().norm() * piece.angularVelocity.norm();
    return halfTime * (velocity.norm() + aboutCentre) + piece.deviation + piece.deviationAcrossRotation;
}

/// The motion's pieces. MotionPiece::counts tells where the contact zones let the obstacle count.
MotionPieces SceneClearance::piecesFor(std::size_t i, const PartMotion& motion, double poseError) const {
    PoseClearance at;
    if (!zones_->zoneOf(i, at)) return motion.pieces;
    return [this, i, &motion, poseError](double from, double to) {
        MotionPiece piece = motion.pieces(from, to);
        PoseClearance here;
        zones_->findSlacks(scene_, piece.middle, here);
        const double slack = zones_->zoneOf(i, here)->slack.lower;
        const double half = 0.5 * (to - from);
        const double moved = std::min(half * motion.length, movedInHalf(piece, half)) + poseError;
        if (slack >= moved) {
            piece.counts = MotionPiece::Counts::kNowhere;
        } else if (slack >= 0) {
            piece.counts = MotionPiece::Counts::kNotAtMiddle;
        }
        return piece;
    };
}

ContactsAt SceneClearance::contactsAt(const Pose& X_environmentPart) const {
    PoseClearance at;
    zones_->findSlacks(scene_, X_environmentPart, at);
    return {at.isInStartContact, at.isInGoalContact};
}

SolidsAlong SceneClearance::stayOutsideSolids(const PartMotion& motion, double until, double poseError,
                                              double leastInterval) const {
    SolidsAlong answer;
    answer.until = until;
    PoseClearance none;
    for (std::size_t i = 0; i < scene_.obstacles.size(); ++i) {
        if (!scene_.obstacles[i].solids || !zones_->zoneOf(i, none)) continue;
        answer = stayOutsideSolid(i, motion, answer, poseError, leastInterval);
    }
    return answer;
}

/// Divides the motion until each range is certified, holds a pose inside the solid, or is as short as leastInterval.
/// A range of that length at a zone's boundary stays undecided; up to kLooksBehindBorder further ranges are then
/// searched for a pose inside the solid.
SolidsAlong SceneClearance::stayOutsideSolid(std::size_t i, const PartMotion& motion,
                                             const SolidsAlong& others, double poseError,
                                             double leastInterval) const {
    constexpr int kLooksBehindBorder = 256;
    SolidsAlong answer = others;
    std::vector<TimeRange> left{{0, others.until}};
    for (int looks = 0; !left.empty() && looks < kLooksBehindBorder;) {
        const TimeRange range = left.back();
        left.pop_back();
        const SweepVerdict side = sideAlong(i, motion, range, poseError, leastInterval);
        if (answer.until < others.until) ++looks;
        if (side == SweepVerdict::kCertified) continue;
        if (side == SweepVerdict::kContact) {
            const double until = std::min(answer.until, range.from);
            return {SweepVerdict::kContact, until, earlierOf(answer.contactTime, range.from)};
        }
        const double middle = range.from + 0.5 * (range.to - range.from);
        if (motion.length * (range.to - range.from) > leastInterval) {
            left.push_back({middle, range.to});
            left.push_back({range.from, middle});
            continue;
        }
        answer.until = std::min(answer.until, range.from);
        if (answer.verdict == SweepVerdict::kCertified) answer.verdict = SweepVerdict::kUndecided;
    }
    return answer;
}

/// Decides a range of times. kCertified: no solid holds the other body, or the obstacle is ignored. kContact: a solid
/// holds the other body throughout. kUndecided: the range must be divided.
SweepVerdict SceneClearance::sideAlong(std::size_t i, const PartMotion& motion, const TimeRange& range,
                                       double poseError, double leastInterval) const {
    const MotionPiece piece = motion.pieces(range.from, range.to);
    const Pose& X = piece.middle;
    const double half = 0.5 * (range.to - range.from), travel = 2 * half * motion.length;
    const double moved = std::min(0.5 * travel, movedInHalf(piece, half)) + poseError;
    PoseClearance at;
    zones_->findSlacks(scene_, X, at);
    if (zones_->zoneOf(i, at)->slack.lower >= moved) return SweepVerdict::kCertified;  // ignored throughout
    // No surfaces touch while the obstacle counts, so all of a range in which it counts is on one side.
    if (zones_->countsAround(scene_, i, X, moved)) {
        return enclosureBy(i, X) ? SweepVerdict::kContact : SweepVerdict::kCertified;
    }
    if (travel > leastInterval) return SweepVerdict::kUndecided;
    const Obstacle& obstacle = scene_.obstacles[i];
    const bool isClear =
        !isWithin(scene_.partFor(obstacle), obstacle.model, X, moved, scratch_->mine().workspaces[i]);
    return isClear && !enclosureBy(i, X) ? SweepVerdict::kCertified : SweepVerdict::kUndecided;
}

SceneSweep SceneClearance::sweep(const PartMotion& motion, const SceneSweepOptions& options) const {
    SceneSweep answer;
    answer.certifiedUntil = options.until;
    const ThreadScratch::ForMotion mine(*scratch_);
    SweepOptions asked;
    asked.from = options.from;
    asked.leastInterval = options.leastInterval;
    asked.poseError = options.poseError;
    asked.isForward = options.isForward;
    if (options.isForward) asked.contactTime = std::min(1.0, options.contactInterval / motion.length);
    asked.isStopped = options.isStopped;
    visitAll(scene_.obstacles.size(), mine->nearest, [&](std::size_t i) {
        const Obstacle& obstacle = scene_.obstacles[i];
        asked.margin = obstacle.margin + options.floor;
        asked.until = answer.certifiedUntil;
        asked.isContactAtEnd =
            answer.contactTime == asked.until || (options.isContactAtEnd && asked.until == options.until);
        const SweepResult found =
            clearway::sweep(scene_.partFor(obstacle), obstacle.model, piecesFor(i, motion, options.poseError),
                            asked, mine->workspaces[i]);
        ++answer.queries;
        ++tallyOfThisThread().sweeps;
        tallyOfThisThread().work += found.counters;
        if (found.verdict == SweepVerdict::kCertified) return true;
        mine->nearest = i;
        const bool isFirst = answer.verdict == SweepVerdict::kCertified;
        if (isFirst || found.verdict == SweepVerdict::kContact) answer.verdict = found.verdict;
        answer.contactTime = earlierOf(answer.contactTime, found.contactTime);
        answer.certifiedUntil = std::min(answer.certifiedUntil, found.certifiedUntil);
        return options.isForward && answer.certifiedUntil > options.from;
    });
    return answer;
}

/// Where it cannot be told whether the part is free, it may collide later on, with any obstacle.
void SceneClearance::lookBehind(const PartMotion& motion, SceneSweepOptions options,
                                MotionAnswer& answer) const {
    const ThreadScratch::ForMotion mine(*scratch_);
    SweepOptions asked;
    asked.from = answer.certifiedUntil;
    asked.leastInterval = options.leastInterval;
    asked.poseError = options.poseError;
    std::optional<double> contactTime;
    for (std::size_t i = 0; i < scene_.obstacles.size() && asked.from < 1; ++i) {
        const Obstacle& obstacle = scene_.obstacles[i];
        asked.margin = obstacle.margin;
        const SweepResult found =
            clearway::sweep(scene_.partFor(obstacle), obstacle.model, piecesFor(i, motion, options.poseError),
                            asked, mine->workspaces[i]);
        ++tallyOfThisThread().sweeps;
        tallyOfThisThread().work += found.counters;
        if (found.verdict == SweepVerdict::kContact) contactTime = earlierOf(contactTime, found.contactTime);
    }
    if (!isFree(motion.pieces(1, 1).middle)) contactTime = earlierOf(contactTime, 1.0);
    if (!contactTime) return;
    answer.verdict = SweepVerdict::kContact;
    answer.contactTime = contactTime;
}

MotionAnswer SceneClearance::check(const RigidMotion& motion, double poseError) const {
    constexpr double kLeastInterval = 1e-5;  // of the part's diagonal
    constexpr double kRounding = 0x1p-47;    // of the lengths involved, see piecesOf
    if (!(poseError >= 0)) {
        throw ArgumentError("poseError is " + shortNumber(poseError) + ", expected 0 or more");
    }
    if (!isFree(motion.start)) return {SweepVerdict::kContact, 0, 0};

    const double radius = scene_.part.radiusAboutOrigin(), angle = motion.rotation.norm();
    const double moved = motion.translation.norm() + angle * radius;
    const PartMotion whole{piecesOf(motion, scene_.part), moved, /*endJump*/ 0};
    SceneSweepOptions options;
    options.poseError = poseError + kRounding * (motion.start.translation.norm() + radius + moved);
    // A part of one point has no diagonal: the motion's length stands for it.
    const double diagonal = scene_.part.box().diagonal().norm();
    options.leastInterval = std::max({kLeastInterval * (diagonal > 0 ? diagonal : moved),
                                      4 * options.poseError, std::numeric_limits<double>::min()});
    options.contactInterval = options.leastInterval;
    options.isForward = true;
    const SceneSweep surfaces = sweep(whole, options);
    const SolidsAlong solids =
        stayOutsideSolids(whole, surfaces.certifiedUntil, options.poseError, options.leastInterval);

    MotionAnswer answer{surfaces.verdict, std::min(surfaces.certifiedUntil, solids.until),
                        earlierOf(surfaces.contactTime, solids.contactTime)};
    const bool isWorse =
        answer.verdict == SweepVerdict::kCertified || solids.verdict == SweepVerdict::kContact;
    if (solids.verdict != SweepVerdict::kCertified && isWorse) answer.verdict = solids.verdict;
    if (answer.verdict == SweepVerdict::kUndecided) lookBehind(whole, options, answer);
    return answer;
}

LeastClearance SceneClearance::leastClearance(const PartMotion& motion,
                                              const LeastClearanceOptions& options) const {
    LeastClearance answer;
    answer.lower = std::numeric_limits<double>::infinity();
    answer.upper = std::min(options.cap.value_or(answer.lower), mostClearance());
    const ThreadScratch::ForMotion mine(*scratch_);
    LeastDistanceOptions asked;
    asked.poseError = options.poseError;
    asked.resolution = options.resolution;
    asked.isStopped = options.isStopped;
    visitAll(scene_.obstacles.size(), mine->nearest, [&](std::size_t i) {
        const Obstacle& obstacle = scene_.obstacles[i];
        asked.margin = obstacle.margin;
        asked.cap = answer.upper;
        const LeastDistance found =
            leastDistance(scene_.partFor(obstacle), obstacle.model, piecesFor(i, motion, options.poseError),
                          asked, mine->workspaces[i]);
        ++answer.queries;
        ++tallyOfThisThread().sweeps;
        tallyOfThisThread().work += found.counters;
        answer.lower = std::min(answer.lower, found.lower);
        answer.isStopped = answer.isStopped || found.isStopped;
        if (found.upper < answer.upper) {
            answer.upper = found.upper;
            answer.time = found.nearest->time;
            mine->nearest = i;
        }
        return !answer.isStopped && answer.upper > 0;  // a motion in contact has no least clearance to find
    });
    return answer;
}

}  // namespace clearway
