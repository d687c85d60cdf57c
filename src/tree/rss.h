// Rectangle swept spheres: all points within a radius of a rectangle.
// Source: Larsen, Gottschalk, Lin, Manocha, Fast Proximity Queries with Swept Sphere Volumes, TR99-018, 1999.
#pragma once

#include "clearway/types.h"

namespace clearway {

/// A rectangle swept sphere in double, in mesh coordinates.
struct Rss {
    Vector3 centre = Vector3::Zero();    ///< of the rectangle
    Matrix3 axes = Matrix3::Identity();  ///< columns a0, a1 (along the rectangle's sides) and a2 = a0 x a1
    double halfLength0 = 0;              ///< half the side along a0
    double halfLength1 = 0;
    double radius = 0;

    /// The area of the swept surface, with the rectangle's full sides l and w: 4 pi r^2 + 2 l w + 2 pi r (l + w).
    double area() const;
};

/// A rectangle swept sphere as the kernels read it: floats relative to a tree's origin, in a tree's unit. The
/// axes are rounded, so they are orthonormal only to float; the radius is measured from the stored rectangle.
struct FloatRss {
    float centre[3];
    float axis0[3];
    float axis1[3];
    float halfLength0;
    float halfLength1;
    float radius;
};

/// The least float that is not below the value.
float roundedUp(double value);

/// A length and an entry of an axis as they are stored, tree units. Small ones become 0, because products of the others are then
/// never denormal floats, which are slow. Bounds stay sound: the radius is measured from the stored rectangle.
float storedLength(double length);
float storedAxisEntry(double entry);

/// The radius that holds every point, given the largest of their squared distances from the stored rectangle and of their squared
/// distances from the origin, computed in double without fused operations: rounded up, with room for the rounding of both. Tree
/// units.
float storedRadius(const FloatRss& rectangle, double distanceSquared, double normSquared);

}  // namespace clearway
