// The distance of two triangles in long double, computed the plain way: every pair of features is tried, and
// only points that lie on the triangles are scored. Shares no code with the library; checked against
// exact_distance.h.
#pragma once

#include <array>

#include "clearway/types.h"

namespace clearway::testing {

using LongVector = Eigen::Matrix<long double, 3, 1>;
using LongTriangle = std::array<LongVector, 3>;

struct TriangleDistance {
    long double distance = 0;
    LongVector pointOnA = LongVector::Zero();
    LongVector pointOnB = LongVector::Zero();
};

/// The distance of any triangles, including segments and points (equal or collinear corners). The witness
/// points lie on their triangles up to rounding and are `distance` apart. The distance is never too small,
/// but a piercing pair may come out at some 1e-19 of its size instead of 0 (more for needles).
TriangleDistance triangleDistance(const LongTriangle& a, const LongTriangle& b);

LongVector closestOnTriangle(const LongVector& point, const LongTriangle& triangle);

/// The corners in long double, exactly.
LongTriangle toLong(const std::array<Vector3, 3>& triangle);

/// The triangle moved by the pose in long double.
LongTriangle moved(const Pose& X_ab, const std::array<Vector3, 3>& triangle);
LongVector moved(const Pose& X_ab, const Vector3& point);

}  // namespace clearway::testing
