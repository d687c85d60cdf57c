// Resolves one pair of triangles in double: the one place where a verdict on a pair is made.
#pragma once

#include <cstdint>

#include "query/pair_query.h"

namespace clearway {

/// What double arithmetic can say of a pair; query units, environment frame. It depends on the pair's exact
/// vertices and the pose alone, never on how the pair was found.
struct ResolvedPair {
    double lower = 0;  ///< <= true distance; 0 on contact
    double upper = 0;  ///< >= true distance; 0 on contact
    bool contact = false;
    double pointOnPart[3];
    double pointOnEnvironment[3];
};

/// Contact is what cannot be proved farther apart than kContactRoundoffs u64 M, so a pair that touches is
/// never called free. For triangles as long as the coordinates are large the proof itself rounds by up to 38
/// u64 M, and that counts instead.
constexpr double kContactRoundoffs = 32;

/// A pair in query units, relative to the environment triangle's first corner: the part's first corner,
/// moved, and the edges from either triangle's first corner to its second and third; the part's are not
/// rotated.
struct PairVertices {
    double firstCorner[3];
    double partEdge[2][3];
    double environmentEdge[2][3];
};
PairVertices pairVertices(const PairQuery& query, std::uint32_t partTriangle,
                          std::uint32_t environmentTriangle);

/// partTriangle, environmentTriangle: positions in the trees.
ResolvedPair resolvePair(const PairQuery& query, std::uint32_t partTriangle,
                         std::uint32_t environmentTriangle);

}  // namespace clearway
