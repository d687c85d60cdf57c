// How far a turn about an axis can reach: much less than the radius about the origin when the axis runs along
// a long part.
#pragma once

#include "tree/flat_tree.h"

namespace clearway {

/// How much more than the largest vertex distance the answer may be.
constexpr double kAxisRadiusExcess = 1e-3;

/// Upper bound of the largest distance of a vertex in the tree from the line through the mesh origin along a
/// unit vector, at most kAxisRadiusExcess of it too much but for rounding. Allocates nothing.
double radiusAboutAxis(const FlatTree& tree, const Vector3& unitDirection);

}  // namespace clearway
