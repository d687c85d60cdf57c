// Distances of points from the rectangles of volumes, fitted and stored, in long double.
#pragma once

#include <algorithm>

#include "tree/rss.h"

namespace clearway::testing {

using LongVector = Eigen::Matrix<long double, 3, 1>;

/// The distance from one point of the rectangle: never below the true distance, and equal to it for an
/// orthonormal frame.
inline long double distanceFromRectangle(const LongVector& offset, const LongVector& axis0,
                                         const LongVector& axis1, long double halfLength0,
                                         long double halfLength1) {
    const long double s = std::clamp(offset.dot(axis0), -halfLength0, halfLength0);
    const long double t = std::clamp(offset.dot(axis1), -halfLength1, halfLength1);
    return (offset - s * axis0 - t * axis1).norm();
}

inline long double distanceFromRectangle(const Rss& rss, const Vector3& point) {
    const LongVector offset = point.cast<long double>() - rss.centre.cast<long double>();
    return distanceFromRectangle(offset, rss.axes.col(0).cast<long double>(),
                                 rss.axes.col(1).cast<long double>(), rss.halfLength0, rss.halfLength1);
}

/// point: relative to the tree's origin, in its unit.
inline long double distanceFromRectangle(const FloatRss& rss, const LongVector& point) {
    const auto vectorOf = [](const float(&v)[3]) { return LongVector(v[0], v[1], v[2]); };
    return distanceFromRectangle(point - vectorOf(rss.centre), vectorOf(rss.axis0), vectorOf(rss.axis1),
                                 rss.halfLength0, rss.halfLength1);
}

}  // namespace clearway::testing
