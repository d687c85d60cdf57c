// Triangle pairs that published distance routines get wrong: known ones from bug reports, and families to
// draw from, numbered as in tests/properties/hard_cases.md.
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
    /// The distance where a closed form gives it, NaN where only the oracle can; and how far the coordinates'
    /// own rounding can move it, apart from one roundoff of the distance itself.
    double stated = std::numeric_limits<double>::quiet_NaN();
    double statedWithin = 0;
};

struct KnownPair {
    std::string name;
    TrianglePair pair;
    double distance;  ///< from rational arithmetic, with a relative error of about 1e-15
};

/// Coordinates and answers as stated in public bug reports of other libraries.
std::vector<KnownPair> knownTrianglePairs();

struct TriangleFamily {
    int number;  ///< number of the case in tests/properties/hard_cases.md; 0: none
    std::string name;
    std::function<TrianglePair(Random&)> make;
};

/// Parallel edges, plates at a gap, needles, caps, coplanar and touching pairs, zero-area triangles, offsets,
/// scales, ...: one row per case. The sizes of "denormals" differ too much for a query.
std::vector<TriangleFamily> hardTriangleFamilies();

/// A pose that turns the pair in any way and moves it by at most its own size, so that it fits a query at any
/// scale.
Pose poseFor(Random& random, const TrianglePair& pair);

/// The triangle as a mesh of its own.
Mesh meshOf(const Triangle& triangle);

}  // namespace clearway::testing
