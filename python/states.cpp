// Answers about the plain numbers of OMPL's states, for python/clearway/ompl.py: no other extension can take
// the types of OMPL's Python bindings. Motions are certified as OMPL's SE(3) and SE(2) interpolate them.
#include <pybind11/pybind11.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "clearway/scene_clearance.h"
#include "python/arrays.h"
#include "python/bindings.h"
#include "python/released_gil.h"
#include "python/scenes.h"

namespace clearway::python {
namespace {

using Vector4 = Eigen::Matrix<double, 4, 1, Eigen::DontAlign>;

/// OMPL's: a quaternion's length may be off 1 by less. Two rotations whose quaternions have a product nearer
/// to 1 count as equal, and their interpolation keeps the first one.
constexpr double kOmplNormError = 1e-9;

/// How far OMPL's rates are off constant ones, as a share, because its slerp takes an acos of quaternions
/// that have unit length only to 1e-9.
constexpr double kRateError = 1e-7;

/// How far OMPL's poses are off those of the pieces here, as a share of the lengths involved. Either is off
/// exact arithmetic by 2^-47 (Motion derives it), at each end of an interval; where the second state stands
/// for the end of the interpolation, a third one adds to it.
constexpr double kPoseError = 6 * 0x1p-47;

constexpr double kLeastInterval = 1e-5;  ///< of the part's diagonal, as MotionValidator has it

struct State {
    Vector3 position;
    Vector4 quaternion;  ///< x, y, z, w
};

Pose poseOf(const Vector3& position, const Vector4& quaternion) {
    return toPose(Eigen::Quaterniond(quaternion), position);
}

Pose poseOf(const State& state) {
    return poseOf(state.position, state.quaternion);
}

/// Makes a motion with constant velocities. `poseAt`: the pose at a time as OMPL interpolates it.
template <class PoseAt>
PartMotion steadyMotion(const Model& part, const Vector3& velocity, const Vector3& turn,
                        const Vector3& axisInPart, const PoseAt& poseAt) {
    const double angle = turn.norm();
    double radius = 0;  // of the part's box about the axis
    for (int corner = 0; corner < 8; ++corner) {
        const Vector3 at = part.box().corner(static_cast<Box::CornerType>(corner));
        radius = std::max(radius, axisInPart.cross(at).norm() * (1 + 1e-12));
    }
    radius = std::min(radius, part.radiusAboutOrigin());
    const double doubtful = kRateError * (velocity.norm() + angle * part.radiusAboutOrigin());
    const auto pieces = [=](double from, double to) {
        const double half = 0.5 * (to - from);
        MotionPiece piece;
        piece.middle = poseAt(from + half);
        piece.velocity = velocity;
        piece.angularVelocity = turn;
        piece.deviation = half * doubtful;
        // Points on a circle are off its tangent by radius angle^2 / 2.
        piece.deviationAcrossTurn = 0.5 * half * half * angle * angle * radius;
        return piece;
    };
    return {pieces, velocity.norm() + angle * radius + doubtful, /*endJump*/ 0};
}

/// OMPL's slerp from a quaternion to `sign` times the other one.
PartMotion turningMotion(const Model& part, const State& s1, const State& s2, double sign) {
    const Vector4 a = s1.quaternion.normalized(), b = sign * s2.quaternion.normalized();
    const double angle = 4 * std::atan2((a - b).norm(), (a + b).norm());
    // The axis of the rotation b * conjugate(a), in the environment's frame; that of conjugate(a) * b is in the
    // part's.
    const Vector3 crossed = b.head<3>().cross(a.head<3>());
    const Vector3 difference = a.w() * b.head<3>() - b.w() * a.head<3>();
    const Vector3 velocity = s2.position - s1.position, turn = angle * (difference - crossed).normalized();
    const double theta = std::acos(std::abs(s1.quaternion.dot(s2.quaternion)));
    const auto poseAt = [=](double time) {
        const double first = std::sin((1 - time) * theta), second = sign * std::sin(time * theta);
        return poseOf(s1.position + time * velocity,
                      (first * s1.quaternion + second * s2.quaternion) / std::sin(theta));
    };
    return steadyMotion(part, velocity, turn, (difference + crossed).normalized(), poseAt);
}

/// The motion in which OMPL leaves the turn out.
PartMotion straightMotion(const Model& part, const State& s1, const State& s2) {
    const Vector3 velocity = s2.position - s1.position;
    const auto poseAt = [=](double time) { return poseOf(s1.position + time * velocity, s1.quaternion); };
    return steadyMotion(part, velocity, Vector3::Zero(), Vector3::Zero(), poseAt);
}

State stateOfSe2(double x, double y, double yaw) {
    return {{x, y, 0}, {0, 0, std::sin(0.5 * yaw), std::cos(0.5 * yaw)}};
}

PartMotion planarMotion(const Model& part, const Vector3& s1, const Vector3& s2) {
    double turn = s2.z() - s1.z();  // OMPL turns the shorter way
    if (turn > M_PI) turn -= 2 * M_PI;
    if (turn < -M_PI) turn += 2 * M_PI;
    const Vector3 velocity(s2.x() - s1.x(), s2.y() - s1.y(), 0);
    const auto poseAt = [=](double time) {
        return poseOf(
            stateOfSe2(s1.x() + time * velocity.x(), s1.y() + time * velocity.y(), s1.z() + time * turn));
    };
    return steadyMotion(part, velocity, {0, 0, turn}, Vector3::UnitZ(), poseAt);
}

/// Certifies the poses of one motion, whose second state is free.
SweepVerdict certify(const SceneClearance& clearance, const PartMotion& motion, const Pose& start,
                     const Pose& end) {
    const Scene& scene = clearance.scene();
    if (motion.length == 0)
        return clearance.isFree(start) ? SweepVerdict::kCertified : SweepVerdict::kContact;
    const double part = scene.part.box().diagonal().norm();
    const double size = part > 0 ? part : scene.environmentBox().diagonal().norm();
    SceneSweepOptions options;
    options.poseError = kPoseError * (scene.part.radiusAboutOrigin() + motion.length + scene.largestMargin() +
                                      std::max(start.translation.norm(), end.translation.norm()));
    options.leastInterval = std::max(kLeastInterval * (size > 0 ? size : 1), 8 * options.poseError);
    const SweepVerdict verdict = clearance.sweep(motion, options).verdict;
    if (verdict != SweepVerdict::kCertified || !clearance.hasSolids()) return verdict;
    if (!clearance.isFree(start)) return SweepVerdict::kContact;
    return clearance.stayOutsideSolids(motion, 1, options.poseError, options.leastInterval).verdict;
}

void requireUnitLength(const State& state, const char* name) {
    const double length = state.quaternion.norm();
    if (std::abs(length - 1) < kOmplNormError) return;
    throw std::invalid_argument("the quaternion of " + std::string(name) + " has length " +
                                std::to_string(length) + ", expected 1 to within 1e-9");
}

/// Whether OMPL leaves the turn out, and which way it turns otherwise, depends on the signs of two numbers
/// that OMPL rounds. Where one is as small as its rounding, all that OMPL may do must be free.
SweepVerdict certifySe3(const SceneClearance& clearance, const State& s1, const State& s2) {
    requireUnitLength(s1, "the first state");
    requireUnitLength(s2, "the second state");
    const Pose start = poseOf(s1), end = poseOf(s2);
    if (!clearance.isFree(end)) return SweepVerdict::kContact;

    const Vector4 products = s1.quaternion.cwiseProduct(s2.quaternion);
    const double product = products.sum(), rounding = 8 * 0x1p-53 * products.cwiseAbs().sum();
    const double nearness = std::abs(product) - (1 - kOmplNormError);  // above 0: OMPL leaves the turn out
    const Model& part = clearance.scene().part;
    SweepVerdict worst = SweepVerdict::kCertified;
    const auto add = [&](const PartMotion& motion) {
        if (worst == SweepVerdict::kCertified) worst = certify(clearance, motion, start, end);
    };
    if (nearness > -rounding) add(straightMotion(part, s1, s2));
    if (nearness > rounding) return worst;
    if (product >= -rounding) add(turningMotion(part, s1, s2, 1));
    if (product < 0 || (product <= rounding && rounding > 0)) add(turningMotion(part, s1, s2, -1));
    return worst;
}

SweepVerdict certifySe2(const SceneClearance& clearance, const Vector3& s1, const Vector3& s2) {
    const Pose start = poseOf(stateOfSe2(s1.x(), s1.y(), s1.z()));
    const Pose end = poseOf(stateOfSe2(s2.x(), s2.y(), s2.z()));
    if (!clearance.isFree(end)) return SweepVerdict::kContact;
    return certify(clearance, planarMotion(clearance.scene().part, s1, s2), start, end);
}

const char* nameOf(SweepVerdict verdict) {
    switch (verdict) {
        case SweepVerdict::kCertified:
            return "certified";
        case SweepVerdict::kContact:
            return "contact";
        case SweepVerdict::kUndecided:
            break;
    }
    return "undecided";
}

}  // namespace

void bindStates(py::module_& module) {
    module.def(
        "is_free_at_state",
        [](const PyScene& scene, double x, double y, double z, double qx, double qy, double qz, double qw) {
            return scene.clearance.isFree(poseOf({x, y, z}, {qx, qy, qz, qw}));
        },
        WithoutGil(), R"(Scene.is_free at a position and a quaternion, which is normalised first.)");
    module.def(
        "clearance_at_state",
        [](const PyScene& scene, double x, double y, double z, double qx, double qy, double qz, double qw) {
            return scene.clearance.at(poseOf({x, y, z}, {qx, qy, qz, qw})).lower;
        },
        WithoutGil(), R"(Scene.clearance at a position and a quaternion, which is normalised first.)");
    module.def(
        "certify_se3_motion",
        [](const PyScene& scene, double x1, double y1, double z1, double qx1, double qy1, double qz1,
           double qw1, double x2, double y2, double z2, double qx2, double qy2, double qz2, double qw2) {
            return nameOf(certifySe3(scene.clearance, {{x1, y1, z1}, {qx1, qy1, qz1, qw1}},
                                     {{x2, y2, z2}, {qx2, qy2, qz2, qw2}}));
        },
        WithoutGil(),
        R"(Certifies both states and all poses that OMPL's SE(3) interpolates between them. Returns "certified", "contact" or
"undecided".)");
    module.def(
        "certify_se2_motion",
        [](const PyScene& scene, double x1, double y1, double yaw1, double x2, double y2, double yaw2) {
            return nameOf(certifySe2(scene.clearance, {x1, y1, yaw1}, {x2, y2, yaw2}));
        },
        WithoutGil(),
        R"(Certifies both states and all poses that OMPL's SE(2) interpolates between them. Returns "certified", "contact" or
"undecided".)");
}

}  // namespace clearway::python
