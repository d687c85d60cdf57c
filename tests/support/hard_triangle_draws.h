// The two kinds of families of hard_triangles.h, and what both draw with.
#pragma once

#include "support/hard_triangles.h"

namespace clearway::testing {

/// Half the side of the box from which most triangles are drawn.
constexpr double kDrawSize = 500;

Triangle randomTriangle(Random& random, double halfSide = kDrawSize);

/// A number from 10^-low to 10^-high.
double powerOfTen(Random& random, int low, int high);

/// Turns the pair. The distance stays the pair's, up to the rounding of the corners.
TrianglePair movedBy(const TrianglePair& pair, const Pose& pose);

/// Half of the draws keep their round coordinates (ties, exact parallels); the other half are turned.
TrianglePair sometimesTurned(Random& random, const TrianglePair& pair);

/// Those whose distance has a closed form, which is written into the pair.
std::vector<TriangleFamily> statedFamilies();

/// Those left to the oracle.
std::vector<TriangleFamily> drawnFamilies();

}  // namespace clearway::testing
