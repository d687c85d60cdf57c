#include "mesh/degenerate.h"

#include <cmath>
#include <limits>

// g++ 12 sees an uninitialised limb in Boost's constructor of a zero, wherever that is inlined.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#include <boost/multiprecision/cpp_int.hpp>
#pragma GCC diagnostic pop

namespace clearway {

namespace {

using Rational = boost::multiprecision::cpp_rational;

/// Of the relative error of a difference of two products of rounded differences: (3 + 16 u64) u64 < 4 *
/// 2^-53.
constexpr double kRelativeError = 4.5e-16;

/// The area of the projection onto the plane of axes i and j differs from zero, proven in double. Terms below
/// the smallest normal number prove nothing.
bool hasProjectedArea(const Vector3& u, const Vector3& v, int i, int j) {
    const double left = u[i] * v[j];
    const double right = u[j] * v[i];
    const double error =
        kRelativeError * (std::fabs(left) + std::fabs(right)) + std::numeric_limits<double>::min();
    return std::fabs(left - right) > error;
}

bool isExactlyDegenerate(const Vector3& a, const Vector3& b, const Vector3& c) {
    Rational u[3];
    Rational v[3];
    for (int i = 0; i < 3; ++i) {
        u[i] = Rational(b[i]) - Rational(a[i]);
        v[i] = Rational(c[i]) - Rational(a[i]);
    }
    return u[0] * v[1] == u[1] * v[0] && u[1] * v[2] == u[2] * v[1] && u[2] * v[0] == u[0] * v[2];
}

}  // namespace

bool isDegenerate(const Vector3& a, const Vector3& b, const Vector3& c) {
    if (a == b || b == c || c == a) return true;
    const Vector3 u = b - a;
    const Vector3 v = c - a;
    // An overflow makes the difference NaN or the error infinite, and nothing is proven.
    if (hasProjectedArea(u, v, 0, 1) || hasProjectedArea(u, v, 1, 2) || hasProjectedArea(u, v, 2, 0))
        return false;
    return isExactlyDegenerate(a, b, c);
}

}  // namespace clearway
