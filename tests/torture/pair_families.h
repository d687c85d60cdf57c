// The families of the torture run: pairs of triangles, and of few triangles, drawn to be as hard on a
// distance query as can be, in the frames and poses that a caller may bring them in.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "support/hard_triangles.h"
#include "support/random_meshes.h"

namespace clearway::testing {

/// What is asked: the part at its pose against the environment.
struct PosedMeshes {
    Mesh part;
    Mesh environment;
    Pose pose;
};

struct PairFamily {
    std::string name;
    std::function<PosedMeshes(Random&)> make;
};

/// needle, cap, parallel, coplanar, near-touch, touch, offset, scale, mixed-size, degenerate, random, grid
/// and cluster (several triangles each). About half of the draws touch or nearly do.
std::vector<PairFamily> pairFamilies();

/// A pair as a part and an environment: the part's own coordinates are the pair's taken back by the pose and
/// rounded. One pose in four is the identity, one a translation, one a quarter turn with a translation by
/// whole multiples of a power of two, which round little or nothing, and one any.
PosedMeshes posedAnyhow(Random& random, const TrianglePair& pair);

/// The pair moved until it is about 2^-10 to 2^-56 of its size apart; it may come out touching.
TrianglePair broughtNear(Random& random, const TrianglePair& pair);

/// A pair that shares a point in exact arithmetic. Coordinates are multiples of 1/4 below 4096.
TrianglePair touchingPair(Random& random);

}  // namespace clearway::testing
