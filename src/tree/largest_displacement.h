// How far a turn about an axis, or a motion from one pose to another, can move a vertex. For long parts and
// small turns this is much less than the radius about the origin suggests.
#pragma once

#include "clearway/types.h"
#include "tree/flat_tree.h"

namespace clearway {

/// Relative amount by which radiusAboutAxis may exceed the largest vertex distance.
constexpr double kAxisRadiusExcess = 1e-3;

/// Upper bound of the largest distance between a vertex in the tree and the line through the mesh origin
/// along a unit vector. Except for rounding, it exceeds that distance by at most the share kAxisRadiusExcess.
/// Allocates nothing.
double radiusAboutAxis(const FlatTree& tree, const Vector3& unitDirection);

/// Relative amount by which largestDisplacement may exceed the largest vertex displacement.
constexpr double kDisplacementExcess = 1e-6;

/// Upper bound of the largest distance between the places to which two poses move a vertex in the tree.
/// Except for rounding, it exceeds that distance by at most the share kDisplacementExcess. When a vertex
/// moves further than the cap, the answer is only known to be above the cap. Allocates nothing.
double largestDisplacement(const FlatTree& tree, const Pose& from, const Pose& to, double cap);

}  // namespace clearway
