// The plain values that every layer shares: points, boxes and rigid poses.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <limits>
#include <string>

#include "clearway/errors.h"

#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ != __ORDER_LITTLE_ENDIAN__
#error "this processor is big-endian, clearway expects a little-endian one: it was not tried on others"
#endif

#pragma GCC visibility push(default)

namespace clearway {

/// Three doubles: a point, a direction or a translation, in the frame and unit that the user of it states.
using Vector3 = Eigen::Vector3d;

/// Three by three doubles, such as a rotation. The alignment of this type and of Vector3 depends on no option
/// of the compiler.
using Matrix3 = Eigen::Matrix3d;

/// A box along the axes of its frame, given by its least and largest corner. A new box is empty: it holds no
/// point. The border belongs to the box.
using Box = Eigen::AlignedBox3d;

/// The map x_a = rotation * x_b + translation from coordinates in frame b to coordinates in frame a, written
/// X_ab. It is defined as the affine map of these 12 doubles in exact arithmetic.
struct Pose {
    Matrix3 rotation = Matrix3::Identity();  ///< R_ab: its columns are the axes of b in frame a
    Vector3 translation = Vector3::Zero();   ///< p_ab: the origin of b in frame a, in the length unit of a
};

/// Largest rotation defect (see rotationDefect) that a query accepts; dimensionless.
constexpr double kPoseDefect = 1e-12;

/// Largest rotation defect that nearestPose accepts, as of a rotation written with few digits; dimensionless.
constexpr double kProjectableDefect = 1e-5;

/// The point p_b in frame a.
inline Vector3 operator*(const Pose& X_ab, const Vector3& p_b) {
    return X_ab.rotation * p_b + X_ab.translation;
}

/// X_ab * X_bc = X_ac.
inline Pose operator*(const Pose& X_ab, const Pose& X_bc) {
    return {X_ab.rotation * X_bc.rotation, X_ab * X_bc.translation};
}

/// The pose X_ba, computed with the transposed rotation as its inverse.
inline Pose inverse(const Pose& X_ab) {
    return {X_ab.rotation.transpose(), -(X_ab.rotation.transpose() * X_ab.translation)};
}

// Poses from and to Eigen's types. They are inline, and no compiled function takes or returns such a type:
// their alignment depends on the options of the compiler that uses them.

/// The pose of an isometry, number by number. Nothing is checked or normalised: see requirePose and
/// nearestPose.
inline Pose toPose(const Eigen::Isometry3d& X_ab) {
    return {X_ab.linear(), X_ab.translation()};
}

/// The pose of a quaternion and a translation. The quaternion is normalised first. Throws
/// ArgumentError when its length is 0 or not finite.
inline Pose toPose(const Eigen::Quaterniond& rotation, const Vector3& translation) {
    const Eigen::Matrix<double, 4, 1, Eigen::DontAlign> coefficients = rotation.coeffs();
    const double length = coefficients.stableNorm();
    if (!(length > 0 && length < std::numeric_limits<double>::infinity())) {
        throw ArgumentError("the quaternion's length is " + std::to_string(length) +
                            ", expected above 0 and finite");
    }
    // Squares of very small entries would vanish, those of very large ones overflow.
    Eigen::Quaterniond unit(coefficients / length);
    unit.normalize();
    return {unit.toRotationMatrix(), translation};
}

/// The isometry of a pose, number by number.
inline Eigen::Isometry3d toIsometry(const Pose& X_ab) {
    Eigen::Isometry3d isometry;
    isometry.linear() = X_ab.rotation;
    isometry.translation() = X_ab.translation;
    isometry.makeAffine();
    return isometry;
}

/// The rotation as a quaternion of unit length.
inline Eigen::Quaterniond toQuaternion(const Pose& X_ab) {
    return Eigen::Quaterniond(X_ab.rotation).normalized();
}

/// max |R^T R - I|, or infinity if an entry of the pose is not finite or det R <= 0.
double rotationDefect(const Pose& pose);

/// Throws ArgumentError, naming the defect and what was expected, unless rotationDefect <=
/// kPoseDefect.
void requirePose(const Pose& pose);

/// The pose with the rotation nearest to the given matrix in the Frobenius norm (polar decomposition); the
/// translation is kept. Throws ArgumentError when the defect exceeds kProjectableDefect.
Pose nearestPose(const Pose& pose);

}  // namespace clearway

#pragma GCC visibility pop
