// A pair of triangles in double: what can be said of it at the price of some hundred instructions.
#pragma once

#include <cstdint>

#include "exact/verdict.h"
#include "query/pair_query.h"
#include "query/witness.h"

namespace clearway {

/// Where two triangles are closest, as a number: feature 3 i + j is edge i of the part's and edge j of the
/// environment's, edge k going from corner k to the next; 9 + 2 k the part's corner k over the other's face,
/// 10 + 2 k the environment's.
constexpr int kFeatures = 15;

/// What is known of a pair; query units, environment frame. It depends on the pair's exact vertices and the
/// pose alone, never, but for last digits, on how the pair was found.
struct ResolvedPair {
    double lower = 0;  ///< <= true distance; 0 on contact
    double upper = 0;  ///< >= true distance; 0 on contact
    Verdict contact = Verdict::open;
    std::int32_t feature = kNoFeature;     ///< where it is closest
    Vector3 apartAlong = Vector3::Zero();  ///< the direction that proves lower, not of unit length
    Vector3 pointOnPart;                   ///< on contact two points near each other
    Vector3 pointOnEnvironment;
};

/// A pair in query units, relative to the environment triangle's first corner: the part's first corner,
/// moved, and the edges from either triangle's first corner to its second and third; the part's are not
/// rotated.
struct PairVertices {
    double firstCorner[3];
    double partEdge[2][3];
    double environmentEdge[2][3];
};
PairVertices pairVertices(const PairQuery& query, const TrianglesAt& triangles);

/// In double. contact is left open where rounding hides it, which is within some 40 u64 M of contact for good
/// triangles and more for flat ones; the interval's width, likewise, is not promised.
ResolvedPair resolvePair(const PairQuery& query, const TrianglesAt& triangles);

struct ContactInDouble {
    Verdict contact;
    Vector3 apartAlong;  ///< as ResolvedPair's
};

/// Of the same pairs open or not as resolvePair's, but for last digits, without distance and points.
ContactInDouble contactOf(const PairQuery& query, const TrianglesAt& triangles);

}  // namespace clearway
