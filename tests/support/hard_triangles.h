// Triangle pairs that published distance routines get wrong: known ones from bug reports, and families to
// draw from.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "support/random_meshes.h"

namespace clearway::testing {

using Triangle = std::array<Vector3, 3>;

struct TrianglePair {
    Triangle a;
    Triangle b;
};

struct KnownPair {
    std::string name;
    TrianglePair pair;
    double distance;  ///< by rational arithmetic, to about 1e-15 of itself
};

/// Coordinates and answers as public bug reports of other libraries state them.
std::vector<KnownPair> knownTrianglePairs();

struct TriangleFamily {
    std::string name;
    std::function<TrianglePair(Random&)> make;
};

/// Parallel edges, plates at a gap, needles, caps, coplanar and touching pairs, zero-area triangles, offsets,
/// scales, ...
std::vector<TriangleFamily> hardTriangleFamilies();

/// The triangle as a mesh of its own.
Mesh meshOf(const Triangle& triangle);

}  // namespace clearway::testing
