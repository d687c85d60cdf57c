#include "problem/rotation.h"

#include <cmath>

namespace clearway {

namespace {

using Vector3Long = Eigen::Matrix<long double, 3, 1>;
using Vector4Long = Eigen::Matrix<long double, 4, 1>;

/// The vector scaled to length 1. It is divided by its largest entry first, because the square of a length
/// may overflow or vanish.
template <typename Vector>
std::optional<Vector> unit(const Vector& vector) {
    const long double largest = vector.cwiseAbs().maxCoeff();
    if (!vector.allFinite() || !(largest > 0)) return std::nullopt;
    const Vector scaled = vector / largest;
    return Vector(scaled / std::sqrt(scaled.squaredNorm()));
}

}  // namespace

std::optional<Rotation> fromAxisAngle(const AxisAngle& axisAngle) {
    const std::optional<Vector3Long> axis = unit(Vector3Long(axisAngle.axis.cast<long double>()));
    if (!axis || !std::isfinite(axisAngle.angle)) return std::nullopt;
    const long double half = static_cast<long double>(axisAngle.angle) / 2;
    const Eigen::Vector3d xyz = (std::sin(half) * *axis).cast<double>();
    return Rotation(static_cast<double>(std::cos(half)), xyz.x(), xyz.y(), xyz.z());
}

AxisAngle toAxisAngle(const Rotation& rotation) {
    const Vector3Long xyz = rotation.vec().cast<long double>();
    const std::optional<Vector3Long> axis = unit(xyz);
    if (!axis) return {};
    const long double half = std::atan2(xyz.dot(*axis), static_cast<long double>(rotation.w()));
    return {axis->cast<double>(), static_cast<double>(2 * half)};
}

double yawOf(const Rotation& rotation) {
    // q and -q are one rotation; the quaternion with w >= 0 has its half angle in [-pi/2, pi/2].
    const double sign = std::signbit(rotation.w()) ? -1 : 1;
    return 2 * std::atan2(sign * rotation.z(), sign * rotation.w());
}

std::optional<Matrix3> matrixOf(const Rotation& rotation) {
    const std::optional<Vector4Long> q = unit(Vector4Long(rotation.coeffs().cast<long double>()));
    if (!q) return std::nullopt;
    const Eigen::Quaternion<long double> exact((*q)[3], (*q)[0], (*q)[1], (*q)[2]);
    return Matrix3(exact.toRotationMatrix().cast<double>());
}

std::optional<Rotation> normalized(const Rotation& rotation) {
    const std::optional<Vector4Long> coefficients = unit(Vector4Long(rotation.coeffs().cast<long double>()));
    if (!coefficients) return std::nullopt;
    const Eigen::Vector4d rounded = coefficients->cast<double>();
    return Rotation(rounded[3], rounded[0], rounded[1], rounded[2]);
}

}  // namespace clearway
