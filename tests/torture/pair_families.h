// The families of the torture run: pairs of triangles, and of a few triangles, drawn to be as hard as
// possible for a distance query, in the frames and poses that callers use.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "support/hard_triangles.h"
#include "support/random_meshes.h"

namespace clearway::testing {

/// One case: the part at its pose, and the environment.
struct PosedMeshes {
    Mesh part;
    Mesh environment;
    Pose pose;
};

struct PairFamily {
    std::string name;
    std::function<PosedMeshes(Random&)> make;
};

/// The families needle, cap, parallel, coplanar, near-touch, touch, offset, scale, mixed-size, degenerate,
/// random, grid and cluster (several triangles each). About half of the draws touch or nearly touch.
std::vector<PairFamily> pairFamilies();

/// Makes a part and an environment of a pair. The part's own coordinates are the pair's, moved back by the
/// pose and rounded. Of four poses one is the identity, one a translation, one a quarter turn with a
/// translation by whole multiples of a power of two, and one is arbitrary. The first three round little or
/// nothing.
PosedMeshes posedAnyhow(Random& random, const TrianglePair& pair);

/// Moves the pair until it is about 2^-10 to 2^-56 of its size apart; it may come out touching.
TrianglePair broughtNear(Random& random, const TrianglePair& pair);

/// A pair that shares a point exactly. Coordinates are multiples of 1/4 below 4096.
TrianglePair touchingPair(Random& random);

}  // namespace clearway::testing
