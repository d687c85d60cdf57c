// How far a part must be moved along a line to come free: a certified motion from outside inwards tells.
#include <algorithm>
#include <cmath>
#include <limits>

#include "clearway/errors.h"
#include "clearway/scene_clearance.h"
#include "clearway/sweep.h"
#include "core/number.h"

namespace clearway {
namespace {

constexpr double kBeyond = 1e-3;  ///< of both sizes: how far outside the motion begins
constexpr double kUlps = 1e-12;   ///< of the largest coordinate: more than poses are rounded by
/// The part is kept so far from obstacles, as a share of its diagonal: otherwise it slides along a face in ever smaller steps.
constexpr double kKept = 1e-5;
constexpr double kRounding = 1e-15;  ///< of the bounds
constexpr int kMostHalvings = 60;
constexpr double kResolution = 1e-5;  ///< of the part's diagonal: how close the bounds are to be

/// After a translation so long the box of the part is apart from the other one; 0 if there is none.
double lengthApart(const Box& part, const Box& other, const Vector3& along) {
    double least = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        const double rate = along[axis];
        if (rate == 0) continue;
        const double way =
            rate > 0 ? other.max()[axis] - part.min()[axis] : part.max()[axis] - other.min()[axis];
        least = std::min(least, way / std::abs(rate));
    }
    return std::max(0.0, least);
}

}  // namespace

EscapeDistance SceneClearance::escapeDistance(const Pose& X_environmentPart, const Vector3& direction) const {
    requirePose(X_environmentPart);
    if (!direction.allFinite() || !(direction.stableNorm() > 0)) {
        throw ArgumentError("direction is " + roundedPoint(direction) +
                            ", expected finite numbers, not all 0");
    }
    const Vector3 along = (direction / direction.cwiseAbs().maxCoeff()).normalized();
    const Box& own = scene_.part.box();
    const Vector3 centre = X_environmentPart * own.center(),
                  reach = X_environmentPart.rotation.cwiseAbs() * (0.5 * own.sizes());
    const Box part(centre - reach, centre + reach);
    double length = 0, largest = part.min().cwiseAbs().cwiseMax(part.max().cwiseAbs()).maxCoeff();
    for (const Obstacle& obstacle : scene_.obstacles) {
        Box box = obstacle.model.box();
        if (box.isEmpty()) continue;
        largest = std::max(largest, box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff());
        const double beyond =
            obstacle.margin + kBeyond * (box.diagonal().norm() + part.diagonal().norm()) + kUlps * largest;
        box.min().array() -= beyond;
        box.max().array() += beyond;
        length = std::max(length, lengthApart(part, box, along));
    }
    RigidMotion inwards{X_environmentPart, -length * along, Vector3::Zero()};
    inwards.start.translation += length * along;
    if (!isFree(inwards.start)) {
        throw ArgumentError(
            "the part is not free " + roundedNumber(length) +
            " away, outside of the obstacles' boxes, expected sizes above the rounding of their "
            "coordinates");
    }
    if (length == 0) return {};
    const MotionAnswer answer = check(inwards, kKept * own.diagonal().norm());
    EscapeDistance found;
    found.upper = length * (1 - answer.certifiedUntil) * (1 + kRounding);
    if (answer.contactTime) found.lower = length * (1 - *answer.contactTime) * (1 - kRounding);
    // Where faces slide past each other the certificate ends undecided, some way before a pose that is known to be in contact.
    double from = found.lower;
    for (int k = 0; k < kMostHalvings && found.upper - from > kResolution * own.diagonal().norm(); ++k) {
        const double middle = 0.5 * (from + found.upper);
        Pose moved = X_environmentPart;
        moved.translation += middle * along;
        if (!isFree(moved)) found.lower = middle;
        from = middle;  // where it is free, contacts may follow further out
    }
    return found;
}

}  // namespace clearway
