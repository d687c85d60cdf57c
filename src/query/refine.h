// Resolves one pair of triangles in double: the one place where a verdict on a pair is made.
#pragma once

#include <cstdint>

#include "query/pair_query.h"

namespace clearway {

/// Where two triangles are closest, as a number: feature 3 i + j is edge i of the part's and edge j of the
/// environment's, edge k going from corner k to the next; 9 + 2 k the part's corner k over the other's face,
/// 10 + 2 k the environment's.
constexpr int kFeatures = 15;
constexpr std::int32_t kNoFeature = -1;

/// Two triangles, by their positions in the trees, and where they are closest, as far as is known.
struct TrianglesAt {
    std::uint32_t part;
    std::uint32_t environment;
    std::int32_t feature;  ///< a guess, which costs time alone when it is wrong, or kNoFeature
};

/// What double arithmetic can say of a pair; query units, environment frame. It depends on the pair's exact
/// vertices and the pose alone, never, but for last digits, on how the pair was found.
struct ResolvedPair {
    double lower = 0;  ///< <= true distance; 0 on contact
    double upper = 0;  ///< >= true distance; 0 on contact
    bool contact = false;
    std::int32_t feature = kNoFeature;  ///< where it is closest; kNoFeature on contact
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
PairVertices pairVertices(const PairQuery& query, const TrianglesAt& triangles);

ResolvedPair resolvePair(const PairQuery& query, const TrianglesAt& triangles);

}  // namespace clearway
