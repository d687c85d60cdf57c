// The families of hard_triangles.h one by one: first those whose distance is known in closed form and written
// into the pair, then those left to the oracle.
#pragma once

#include "support/hard_triangles.h"

namespace clearway::testing {

/// Half the side of the box that most triangles are drawn from.
constexpr double kDrawSize = 500;

Triangle randomTriangle(Random& random, double halfSide = kDrawSize);

/// 10^-low .. 10^-high
double powerOfTen(Random& random, int low, int high);

/// Its distance is the pair's but for the rounding of the corners.
TrianglePair movedBy(const TrianglePair& pair, const Pose& pose);

/// Half of the draws keep their round coordinates (ties, exact parallels), half are turned.
TrianglePair sometimesTurned(Random& random, const TrianglePair& pair);

// Closed form.
TrianglePair smallCells(Random& random);
TrianglePair parallelPlates(Random& random);
TrianglePair crossingPlates(Random& random);
TrianglePair axisAlignedPiercing(Random& random);
TrianglePair standingPlate(Random& random);
TrianglePair vertexOverFace(Random& random);
TrianglePair crossingEdges(Random& random);
TrianglePair vertexToVertex(Random& random);
TrianglePair vertexToEdge(Random& random);
TrianglePair nearlyParallelEdges(Random& random);
TrianglePair exactlyParallelEdges(Random& random);
TrianglePair coplanarApart(Random& random);
TrianglePair coplanarNested(Random& random);
TrianglePair coplanarEdgeTouch(Random& random);
TrianglePair identical(Random& random);
TrianglePair sharedVertex(Random& random);
TrianglePair sharedEdge(Random& random);
TrianglePair tJunction(Random& random);

// By the oracle.
TrianglePair randomPair(Random& random);
TrianglePair edgesAlongX(Random& random);
TrianglePair coplanarTurned(Random& random);
TrianglePair needles(Random& random);
TrianglePair caps(Random& random);
TrianglePair segments(Random& random);
TrianglePair points(Random& random);
TrianglePair zeroLengthEdges(Random& random);
TrianglePair integerGrid(Random& random);
TrianglePair farFromOrigin(Random& random);
TrianglePair scaledGrid(Random& random);
TrianglePair mixedSizes(Random& random);
TrianglePair zerosAndDenormals(Random& random);
TrianglePair wholeDenormals(Random& random);
TrianglePair cornerInPlane(Random& random);
TrianglePair nearlyCoplanar(Random& random);

}  // namespace clearway::testing
