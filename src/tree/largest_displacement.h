// How far a turn about an axis, or a way from one pose to another, can move a vertex: for long parts and
// small turns much less than the radius about the origin says.
#pragma once

#include "clearway/types.h"
#include "tree/flat_tree.h"

namespace clearway {

/// How much more than the largest vertex distance radiusAboutAxis may be.
constexpr double kAxisRadiusExcess = 1e-3;

/// Upper bound of the largest distance of a vertex in the tree from the line through the mesh origin along a
/// unit vector, at most kAxisRadiusExcess of it too much but for rounding. Allocates nothing.
double radiusAboutAxis(const FlatTree& tree, const Vector3& unitDirection);

/// How much more than the largest vertex displacement largestDisplacement may be.
constexpr double kDisplacementExcess = 1e-6;

/// Upper bound of the largest distance between where two poses take a vertex in the tree, at most
/// kDisplacementExcess of it too much but for rounding. When a vertex moves further than the cap, all that
/// can be said of the answer is that it is above the cap too. Allocates nothing.
double largestDisplacement(const FlatTree& tree, const Pose& from, const Pose& to, double cap);

}  // namespace clearway
