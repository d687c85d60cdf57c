// Triangle pairs that published distance routines get wrong: known ones from bug reports, and families to
// draw from, numbered as the catalogue of hard cases numbers them.
#pragma once

#include <array>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "support/random_meshes.h"

namespace clearway::testing {

using Triangle = std::array<Vector3, 3>;

struct TrianglePair {
    Triangle a;
    Triangle b;
    /// The distance where it is known in closed form, NaN where only the oracle tells, and how far off it the
    /// coordinates' own rounding can put it, beside a roundoff of itself.
    double stated = std::numeric_limits<double>::quiet_NaN();
    double statedWithin = 0;
};

struct KnownPair {
    std::string name;
    TrianglePair pair;
    double distance;  ///< by rational arithmetic, to about 1e-15 of itself
};

/// Coordinates and answers as public bug reports of other libraries state them.
std::vector<KnownPair> knownTrianglePairs();

struct TriangleFamily {
    int number;  ///< of the case in tests/properties/hard_cases.md; 0 for none
    std::string name;
    std::function<TrianglePair(Random&)> make;
};

/// Parallel edges, plates at a gap, needles, caps, coplanar and touching pairs, zero-area triangles, offsets,
/// scales, ...: a row a case. Those of "denormals" differ too much in size for a query.
std::vector<TriangleFamily> hardTriangleFamilies();

/// Turned anyhow and moved by no more than the pair is large: at any scale within what a query takes.
Pose poseFor(Random& random, const TrianglePair& pair);

/// The triangle as a mesh of its own.
Mesh meshOf(const Triangle& triangle);

}  // namespace clearway::testing
