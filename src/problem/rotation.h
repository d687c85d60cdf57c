// Rotations as problem and path files write them, made in long double so that what is stored is off by
// rounding only.
#pragma once

#include <optional>

#include "clearway/types.h"

namespace clearway {

using Rotation = Eigen::Quaternion<double, Eigen::DontAlign>;

struct AxisAngle {
    Vector3 axis = Vector3::UnitX();  ///< unit length
    double angle = 0;                 ///< radians
};

/// Of unit length; nothing when the axis has length 0. All four numbers finite.
std::optional<Rotation> fromAxisAngle(const AxisAngle& axisAngle);

/// Angle in [0, 2 pi]; about x for the identity.
AxisAngle toAxisAngle(const Rotation& rotation);

/// The angle of a rotation about z, in [-pi, pi].
double yawOf(const Rotation& rotation);

/// The rotation matrix of the quaternion, scaled to unit length first; off by the rounding of its entries
/// only. Nothing when the length is 0 or a number is not finite.
std::optional<Matrix3> matrixOf(const Rotation& rotation);

/// Scaled to unit length; nothing when the length is 0 or a number is not finite.
std::optional<Rotation> normalized(const Rotation& rotation);

}  // namespace clearway
