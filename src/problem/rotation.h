// Rotations in the forms of problem and path files, converted in long double so that stored values are off
// only by their own rounding.
#pragma once

#include <optional>

#include "clearway/types.h"

namespace clearway {

using Rotation = Eigen::Quaternion<double, Eigen::DontAlign>;

struct AxisAngle {
    Vector3 axis = Vector3::UnitX();  ///< unit length
    double angle = 0;                 ///< radians
};

/// The rotation as a quaternion of unit length; empty when the axis has length 0 or a number is not finite.
std::optional<Rotation> fromAxisAngle(const AxisAngle& axisAngle);

/// The rotation as axis and angle in [0, 2 pi]; the axis is x for the identity.
AxisAngle toAxisAngle(const Rotation& rotation);

/// The angle of a rotation about z, in [-pi, pi].
double yawOf(const Rotation& rotation);

/// The rotation matrix of the quaternion, which is scaled to unit length first. The matrix is off only by the
/// rounding of its entries. Empty when the length is 0 or a number is not finite.
std::optional<Matrix3> matrixOf(const Rotation& rotation);

/// The quaternion scaled to unit length; empty when the length is 0 or a number is not finite.
std::optional<Rotation> normalized(const Rotation& rotation);

}  // namespace clearway
