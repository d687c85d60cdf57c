// Rectangle swept spheres: all points within a radius of a rectangle.
// Source: Larsen, Gottschalk, Lin, Manocha, Fast Proximity Queries with Swept Sphere Volumes, TR99-018, 1999.
#pragma once

#include <vector>

#include "clearway/types.h"

namespace clearway {

/// In double, mesh coordinates.
struct Rss {
    Vector3 centre = Vector3::Zero();    ///< of the rectangle
    Matrix3 axes = Matrix3::Identity();  ///< columns a0, a1 (along the rectangle's sides) and a2 = a0 x a1
    double halfLength0 = 0;              ///< half the side along a0
    double halfLength1 = 0;
    double radius = 0;

    /// Of the swept volume, l and w the full sides: 4 pi r^2 + 2 l w + 2 pi r (l + w).
    double area() const;
    /// 4/3 pi r^3 + 2 r l w + pi r^2 (l + w).
    double volume() const;
    /// sqrt(l^2 + w^2) + 2 r.
    double longestExtent() const;
};

/// The same volume as the kernels read it: floats, relative to a tree's origin, in a tree's unit. Its axes
/// are the rounded ones, orthonormal only to float; the radius is measured from the rectangle as stored.
struct FloatRss {
    float centre[3];
    float axis0[3];
    float axis1[3];
    float halfLength0;
    float halfLength1;
    float radius;
};

/// Larsen's fit around the points, whose rectangle lies along the frame's first two columns (orthonormal; the
/// longer side may be either). Holds every point up to rounding in double. At least one point; scaling all by
/// a power of two scales the result exactly, and the order of the points does not matter.
Rss fitRss(const std::vector<Vector3>& points, const Matrix3& axes);

/// The RSS of the points in the frame of their covariance: a0 along the greatest spread, the normal along the
/// smallest. A point that comes twice weighs twice.
Rss fitRss(const std::vector<Vector3>& points);

/// Rounds the rectangle to floats ((x - origin) / unit), then takes as radius the largest distance, in
/// double, of a point from the rectangle as stored, rounded up: so every point is inside the volume that is
/// stored. unit: a power of two.
FloatRss roundOutward(const Rss& rss, const std::vector<Vector3>& points, const Vector3& origin, double unit);

}  // namespace clearway
