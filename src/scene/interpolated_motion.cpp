#include "scene/interpolated_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "clearway/errors.h"
#include "clearway/scene_clearance.h"

namespace clearway {
namespace {

using Vector4 = Eigen::Matrix<double, 4, 1, Eigen::DontAlign>;

/// OMPL's: a quaternion's length may be off 1 by less. Two rotations whose quaternions have a product nearer
/// to 1 count as equal, and their interpolation keeps the first one.
constexpr double kOmplNormError = 1e-9;

/// OMPL leaves a turn out when the product of the quaternions is within 1e-9 of 1, and their norms may be off 1 by as much:
/// at angles up to 1.6e-4 rad.
constexpr double kLeastTrustedTurn = 2e-4;

/// How far OMPL's rates are off constant ones, as a share: its slerp takes an acos of quaternions that have unit length only
/// to 1e-9.
constexpr double kRateError = 1e-7;

/// Covers that error in a bound of displacements, and our own rounding.
constexpr double kUp = 1 + kRateError;

/// Sine of half the angle. Below it the axis is not known well enough to split the translation along it.
constexpr double kLeastAxisSine = 1e-6;

/// Rounding of the axis, in radians times that sine: a few 2^-53.
constexpr double kAxisRounding = 1e-14;

/// The turn between two orientations, whose quaternions have unit length.
struct TurnBetween {
    TurnBetween(const Eigen::Vector4d& a, const Eigen::Vector4d& b)
        : angle(4 * std::atan2((a - b).norm(), (a + b).norm())) {
        const Vector3 crossed = b.head<3>().cross(a.head<3>());
        const Vector3 difference = a.w() * b.head<3>() - b.w() * a.head<3>();
        axis = difference - crossed;
        axisInPart = difference + crossed;
    }

    double angle;  ///< radians
    /// The axis of the rotation b * conjugate(a), in the environment's frame. Turned by conjugate(a), it is the axis in the
    /// part's frame. The length of both is the sine of half the angle.
    Vector3 axis, axisInPart;
};

Eigen::Vector4d unitQuaternion(const PartState& state) {
    return state.rotation.coeffs().normalized();
}

/// OMPL's SE(2) turns the shorter way.
double shorterTurn(const Vector3& from, const Vector3& to) {
    const double turn = to.z() - from.z();
    if (turn > M_PI) return turn - 2 * M_PI;
    return turn < -M_PI ? turn + 2 * M_PI : turn;
}

/// axis: of unit length.
SteadyMotion turning(const PartExtent& part, const Vector3& velocity, double angle, const Vector3& axis,
                     double radius) {
    SteadyMotion motion;
    motion.velocity = velocity;
    motion.angularVelocity = angle * axis;
    motion.radius = radius;
    motion.doubtfulSpeed = kRateError * (velocity.norm() + motion.angularVelocity.norm() * part.aboutOrigin);
    const double along = velocity.dot(axis), across = (velocity - along * axis).norm();
    motion.length = std::hypot(along, across + angle * radius) + motion.doubtfulSpeed;
    return motion;
}

}  // namespace

PartExtent::PartExtent(const Model& part) : aboutOrigin(part.radiusAboutOrigin()) {
    for (int corner = 0; corner < 8; ++corner) {
        corners_[corner] = part.box().corner(static_cast<Box::CornerType>(corner));
    }
}

double PartExtent::about(const Vector3& axis) const {
    double squared = 0;
    for (const Vector3& corner : corners_) squared = std::max(squared, axis.cross(corner).squaredNorm());
    return std::min(aboutOrigin, std::sqrt(squared) * (1 + 1e-12));
}

MotionPiece SteadyMotion::around(const Pose& middle, double halfTime) const {
    MotionPiece piece;
    piece.middle = middle;
    piece.velocity = velocity;
    piece.angularVelocity = angularVelocity;
    // Points on a circle are off its tangent by radius angle^2 / 2.
    const double angle = halfTime * angularVelocity.norm();
    piece.deviationAcrossRotation = 0.5 * angle * angle * radius;
    piece.deviation = halfTime * doubtfulSpeed;
    return piece;
}

bool canBeInterpolated(const PartState& state) {
    return std::abs(state.rotation.norm() - 1) < kOmplNormError;
}

SteadyMotion se3Motion(const PartExtent& part, const PartState& from, const PartState& to,
                       bool turnsTheOtherWay) {
    if (!canBeInterpolated(from) || !canBeInterpolated(to)) {
        SteadyMotion none;
        none.length = std::numeric_limits<double>::quiet_NaN();
        return none;
    }
    const Eigen::Vector4d b = unitQuaternion(to);
    const TurnBetween turn(unitQuaternion(from), turnsTheOtherWay ? Eigen::Vector4d(-b) : b);
    const Vector3 velocity = to.position - from.position;
    if (turn.angle > kLeastTrustedTurn) {
        return turning(part, velocity, turn.angle, turn.axis.normalized(),
                       part.about(turn.axisInPart.normalized()));
    }
    SteadyMotion motion;
    motion.velocity = velocity;
    motion.endJump = turn.angle * part.aboutOrigin;
    const double rounding = kRateError * velocity.norm();
    motion.doubtfulSpeed = motion.endJump + rounding;
    motion.length = velocity.norm() + motion.endJump + rounding;
    return motion;
}

SteadyMotion se2Motion(const PartExtent& part, double radius, const Vector3& from, const Vector3& to) {
    const double turn = shorterTurn(from, to);
    return turning(part, {to.x() - from.x(), to.y() - from.y(), 0}, std::abs(turn),
                   {0, 0, turn < 0 ? -1.0 : 1.0}, radius);
}

double se3Displacement(const PartState& from, const PartState& to, double radius,
                       const RadiusAbout& radiusAbout) {
    if (!canBeInterpolated(from) || !canBeInterpolated(to)) return std::numeric_limits<double>::quiet_NaN();
    const Eigen::Vector4d a = unitQuaternion(from), b = unitQuaternion(to);
    const TurnBetween turn(a, a.dot(b) < 0 ? Eigen::Vector4d(-b) : b);
    const Vector3 d = to.position - from.position;
    const double sine = turn.axis.norm();
    if (!(sine > kLeastAxisSine)) return (d.norm() + turn.angle * radius) * kUp;
    const double along = d.dot(turn.axis) / sine;
    const double across = (d - along / sine * turn.axis).norm();
    const double reach = radiusAbout(turn.axisInPart) + kAxisRounding / sine * radius;
    return std::hypot(along, across + turn.angle * reach) * kUp;
}

double se2Displacement(const Vector3& from, const Vector3& to, double radius) {
    return (std::hypot(to.x() - from.x(), to.y() - from.y()) + std::abs(shorterTurn(from, to)) * radius) *
           kUp;
}

double diagonalOf(const Box& box) {
    return box.isEmpty() ? 0 : box.diagonal().norm();
}

double defaultLeastInterval(const Scene& scene) {
    constexpr double kShare = 1e-5;  // of the part's diagonal
    const double part = diagonalOf(scene.part.box());
    const double size = part > 0 ? part : diagonalOf(scene.environmentBox());
    return kShare * (size > 0 ? size : 1);
}

namespace {

/// How far OMPL's poses are off those of the pieces here, as a share of the lengths involved. Either is off
/// exact arithmetic by 2^-47 (planning's Motion derives it), at each end of an interval; where the second state stands
/// for the end of the interpolation, a third one adds to it.
constexpr double kPoseError = 6 * 0x1p-47;

Pose planarPose(double x, double y, double yaw) {
    return toPose(Eigen::Quaterniond(std::cos(0.5 * yaw), 0, 0, std::sin(0.5 * yaw)), {x, y, 0});
}

/// How near to a contact a motion is followed, in least intervals: a planner has no use for a closer pose.
constexpr double kContactIntervals = 100;

constexpr MotionAnswer kFree{SweepVerdict::kCertified, 1, {}};
constexpr MotionAnswer kBlockedAtStart{SweepVerdict::kContact, 0, 0.0};

/// Certifies the poses of one motion, or follows it. poseAt: the pose at a time, as OMPL interpolates it.
template <class PoseAt>
MotionAnswer certifyPoses(const SceneClearance& clearance, bool isForward, const SteadyMotion& steady,
                          const Pose& start, const Pose& end, const PoseAt& poseAt) {
    const Scene& scene = clearance.scene();
    if (steady.length == 0) return clearance.isFree(start) ? kFree : kBlockedAtStart;
    const PartMotion motion{[&](double from, double until) {
                                const double half = 0.5 * (until - from);
                                return steady.around(poseAt(from + half), half);
                            },
                            steady.length, steady.endJump};
    SceneSweepOptions options;
    options.poseError = kPoseError * (scene.part.radiusAboutOrigin() + motion.length + scene.largestMargin() +
                                      std::max(start.translation.norm(), end.translation.norm()));
    options.leastInterval = std::max(defaultLeastInterval(scene), 8 * options.poseError);
    options.isForward = isForward;
    if (isForward) options.contactInterval = kContactIntervals * options.leastInterval;
    const SceneSweep found = clearance.sweep(motion, options);
    const MotionAnswer answer{found.verdict, isForward ? found.certifiedUntil : 1, found.contactTime};
    if (!isForward && found.verdict != SweepVerdict::kCertified) return answer;
    const bool mayBeginInside = clearance.hasSolids() || answer.certifiedUntil == 0;
    if (mayBeginInside && !clearance.isFree(start)) return kBlockedAtStart;
    if (!clearance.hasSolids()) return answer;
    const SolidsAlong solids =
        clearance.stayOutsideSolids(motion, answer.certifiedUntil, options.poseError, options.leastInterval);
    if (solids.verdict == SweepVerdict::kCertified) return answer;
    return {solids.verdict, solids.until, solids.contactTime};
}

/// The answer about a motion whose last pose is not free.
MotionAnswer blockedAtEnd(MotionAnswer answer) {
    if (!answer.contactTime) answer.contactTime = 1;
    answer.verdict = SweepVerdict::kContact;
    answer.certifiedUntil = std::min(answer.certifiedUntil, std::nextafter(1, 0));
    return answer;
}

void requireUnitLength(const PartState& state, const char* name) {
    if (canBeInterpolated(state)) return;
    throw ArgumentError(fmt::format("the quaternion of {} has length {:f}, expected 1 to within 1e-9", name,
                                    state.rotation.norm()));
}

/// Whether OMPL leaves the turn out, and which way it turns otherwise, depends on the signs of two numbers
/// that OMPL rounds. Where one is as small as its rounding, all that OMPL may do must be free.
MotionAnswer answerSe3(const SceneClearance& clearance, const PartState& from, const PartState& to,
                       bool isForward) {
    requireUnitLength(from, "the first state");
    requireUnitLength(to, "the second state");
    const Vector4 first = from.rotation.coeffs(), second = to.rotation.coeffs();
    const auto poseOf = [](const Vector3& position, const Vector4& quaternion) {
        return toPose(Eigen::Quaterniond(quaternion), position);
    };
    const Pose start = poseOf(from.position, first), end = poseOf(to.position, second);
    const bool isEndFree = clearance.isFree(end);
    if (!isEndFree && !isForward) return {SweepVerdict::kContact, 0, 1.0};

    const Vector4 products = first.cwiseProduct(second);
    const double product = products.sum(), rounding = 8 * 0x1p-53 * products.cwiseAbs().sum();
    const double nearness = std::abs(product) - (1 - kOmplNormError);  // above 0: OMPL leaves the turn out
    const PartExtent part(clearance.scene().part);
    const auto positionAt = [&](double time) -> Vector3 {
        return from.position + time * (to.position - from.position);
    };
    MotionAnswer worst = kFree;
    const auto add = [&](double sign, const auto& poseAt) {
        const SteadyMotion motion = se3Motion(part, from, to, sign < 0);
        if (worst.verdict != SweepVerdict::kCertified && !isForward) return;
        const MotionAnswer one = certifyPoses(clearance, isForward, motion, start, end, poseAt);
        if (one.certifiedUntil < worst.certifiedUntil || worst.verdict == SweepVerdict::kCertified)
            worst = one;
    };
    const auto slerp = [&](double sign) {
        return [&, sign, theta = std::acos(std::abs(product))](double time) {
            const double share = std::sin((1 - time) * theta), other = sign * std::sin(time * theta);
            return poseOf(positionAt(time), (share * first + other * second) / std::sin(theta));
        };
    };
    if (nearness > -rounding) {
        add(product, [&](double time) { return poseOf(positionAt(time), first); });
    }
    if (nearness <= rounding) {
        if (product >= -rounding) add(1, slerp(1));
        if (product < 0 || (product <= rounding && rounding > 0)) add(-1, slerp(-1));
    }
    return isEndFree ? worst : blockedAtEnd(worst);
}

MotionAnswer answerSe2(const SceneClearance& clearance, const Vector3& from, const Vector3& to,
                       bool isForward) {
    const Pose start = planarPose(from.x(), from.y(), from.z()), end = planarPose(to.x(), to.y(), to.z());
    const bool isEndFree = clearance.isFree(end);
    if (!isEndFree && !isForward) return {SweepVerdict::kContact, 0, 1.0};
    const PartExtent part(clearance.scene().part);
    const double turn = shorterTurn(from, to);
    const MotionAnswer answer =
        certifyPoses(clearance, isForward, se2Motion(part, part.about(Vector3::UnitZ()), from, to), start,
                     end, [&](double time) {
                         return planarPose(from.x() + time * (to.x() - from.x()),
                                           from.y() + time * (to.y() - from.y()), from.z() + time * turn);
                     });
    return isEndFree ? answer : blockedAtEnd(answer);
}

}  // namespace

SweepVerdict certifySe3Motion(const SceneClearance& clearance, const PartState& from, const PartState& to) {
    return answerSe3(clearance, from, to, false).verdict;
}

SweepVerdict certifySe2Motion(const SceneClearance& clearance, const Vector3& from, const Vector3& to) {
    return answerSe2(clearance, from, to, false).verdict;
}

MotionAnswer followSe3Motion(const SceneClearance& clearance, const PartState& from, const PartState& to) {
    return answerSe3(clearance, from, to, true);
}

MotionAnswer followSe2Motion(const SceneClearance& clearance, const Vector3& from, const Vector3& to) {
    return answerSe2(clearance, from, to, true);
}

}  // namespace clearway
