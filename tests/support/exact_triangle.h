// The distance of two triangles in rational arithmetic. The squared distance of rational points is rational,
// so it has no error at all. It is slow (about a millisecond per pair): for near-ties, and to check the long
// double distance.
#pragma once

#include <array>

#include "clearway/types.h"

#include <boost/multiprecision/cpp_int.hpp>

namespace clearway::testing {

using Rational =
    boost::multiprecision::number<boost::multiprecision::cpp_rational_backend, boost::multiprecision::et_off>;
using ExactPoint = std::array<Rational, 3>;
using ExactTriangle = std::array<ExactPoint, 3>;

/// The squared distance of any triangles, including segments and points; 0 exactly when they share a point.
Rational exactDistanceSquared(const ExactTriangle& a, const ExactTriangle& b);

bool sharePoint(const ExactTriangle& a, const ExactTriangle& b);

/// The values of the doubles.
ExactTriangle toExact(const std::array<Vector3, 3>& triangle);

/// R x + t from the pose's 12 doubles, without rounding.
ExactTriangle exactlyMoved(const Pose& X_ab, const std::array<Vector3, 3>& triangle);

/// The square root of the exact square, rounded.
long double rootOf(const Rational& square);

}  // namespace clearway::testing
