#include "planning/improve/screw.h"

#include <algorithm>
#include <cmath>

namespace clearway::planning {
namespace {

/// sin(x) / x, (1 - cos x) / x^2 and (x - sin x) / x^3, accurate for small x too.
struct Coefficients {
    double first, second, third;
};

Coefficients coefficientsOf(double angle) {
    constexpr double kSmall = 0.05;  // below it the series' next terms are below 2^-53
    const double square = angle * angle;
    if (angle < kSmall) {
        return {1 - square / 6 * (1 - square / 20 * (1 - square / 42)),
                0.5 * (1 - square / 12 * (1 - square / 30 * (1 - square / 56))),
                1.0 / 6 * (1 - square / 20 * (1 - square / 42 * (1 - square / 72)))};
    }
    const double half = std::sin(0.5 * angle);
    return {std::sin(angle) / angle, 2 * half * half / square, (angle - std::sin(angle)) / (square * angle)};
}

Matrix3 crossMatrix(const Vector3& w) {
    Matrix3 cross;
    cross << 0, -w.z(), w.y(), w.z(), 0, -w.x(), -w.y(), w.x(), 0;
    return cross;
}

/// The largest speed of the box's corners, and the largest speed across the axis: along a screw neither changes.
struct Speeds {
    double all = 0, across = 0;
};

Speeds speedsOf(const Screw& screw, const Pose& X_environmentPart, const Box& box) {
    const double rate = screw.angular.norm();
    const Vector3 axis = rate > 0 ? Vector3(screw.angular / rate) : Vector3::Zero();
    Speeds speeds;
    for (int corner = 0; corner < 8; ++corner) {
        const Vector3 point = X_environmentPart * box.corner(Box::CornerType(corner));
        const Vector3 velocity = screw.velocity + screw.angular.cross(point);
        speeds.all = std::max(speeds.all, velocity.norm());
        speeds.across = std::max(speeds.across, (velocity - axis.dot(velocity) * axis).norm());
    }
    return speeds;
}

}  // namespace

Pose movedAlong(const Screw& screw, const Pose& X_environmentPart, double time) {
    const Vector3 turn = time * screw.angular, shift = time * screw.velocity;
    const Coefficients c = coefficientsOf(turn.norm());
    const Matrix3 cross = crossMatrix(turn), square = cross * cross;
    const Matrix3 rotation = Matrix3::Identity() + c.first * cross + c.second * square;
    const Vector3 translation = shift + c.second * (cross * shift) + c.third * (square * shift);
    return {rotation * X_environmentPart.rotation, rotation * X_environmentPart.translation + translation};
}

Screw screwBetween(const Pose& from, const Pose& to) {
    const Pose step = to * inverse(from);
    Eigen::Quaterniond q = toQuaternion(step);
    if (q.w() < 0) q.coeffs() *= -1;
    const double sine = q.vec().norm(), angle = 2 * std::atan2(sine, q.w());
    const Vector3 turn = sine > 0 ? Vector3(angle / sine * q.vec()) : Vector3::Zero();
    const Coefficients c = coefficientsOf(angle);
    const Matrix3 cross = crossMatrix(turn);
    const Matrix3 shifts = Matrix3::Identity() + c.second * cross + c.third * (cross * cross);
    return {turn, shifts.partialPivLu().solve(step.translation)};
}

PartMotion motionAlong(const Screw& screw, const Pose& from, const Model& part) {
    const Speeds speeds = speedsOf(screw, from, part.box());
    const double rate = screw.angular.norm();
    PartMotion motion;
    motion.length = speeds.all;
    motion.endJump = 0;
    motion.pieces = [=](double begin, double end) {
        MotionPiece piece;
        const double half = 0.5 * (end - begin);
        piece.middle = movedAlong(screw, from, begin + half);
        piece.velocity = screw.velocity + screw.angular.cross(piece.middle.translation);
        piece.angularVelocity = screw.angular;
        piece.deviationAcrossRotation = 0.5 * rate * speeds.across * half * half;
        return piece;
    };
    return motion;
}

}  // namespace clearway::planning
