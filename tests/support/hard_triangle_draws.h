// The families of hard_triangles.h one by one: first those whose distance has a closed form, which is written
// into the pair, then those left to the oracle.
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

// Families with a closed form.
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

// Families left to the oracle.
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
