// The distance of a pair of triangles in double, with proof, for a few hundred instructions.
#pragma once

#include <cstdint>

#include "exact/numbers.h"
#include "query/pair_query.h"

namespace clearway {

/// A point of a triangle: corner + s (next corner - corner) + t (last corner - corner); s, t and s + t in [0,
/// 1].
struct PlaceInTriangle {
    int corner = 0;
    double s = 0, t = 0;
};

/// The point in coordinates, off its triangle by at most 3.6 u64 of its largest coordinate; half of that on
/// an edge.
Vector3 pointAt(const PlaceInTriangle& place, const Corners& triangle);

/// |p - q| with a relative error of at most 1.5 u64.
double lengthBetween(const Vector3& p, const Vector3& q);

/// An upper bound of the distance of two triangles from a point of each. Each point is off its true triangle,
/// in u64 M, by the part's rounded corners, 1.8, and by its own rounding: 1.8 for a point within an edge, of
/// which there are at most two; 0 for a corner and 3.6 for its point on a face.
inline double upperBoundFrom(const Vector3& p, const Vector3& q, double M) {
    constexpr double kPointRoundoffs = 6;
    return lengthBetween(p, q) * (1 + 2 * kUnitRoundoffDouble) + kPointRoundoffs * kUnitRoundoffDouble * M;
}

/// Bounds of a pair's distance and its closest points; query units, environment frame. Up to last digits, the
/// values depend only on the pair's exact vertices and the pose, not on how the pair was found.
struct ResolvedPair {
    double lower = 0;  ///< <= true distance; 0 on contact
    double upper = 0;  ///< >= true distance; 0 on contact
    Verdict contact = Verdict::open;
    std::int32_t feature = kNoFeature;     ///< where the pair is closest
    Vector3 apartAlong = Vector3::Zero();  ///< the direction that proves lower, not of unit length
    Vector3 pointOnPart;                   ///< on contact, the two points are near each other
    Vector3 pointOnEnvironment;
};

/// Resolves a pair in double. Contact stays open where rounding hides it: within some 40 u64 M of contact for
/// well-shaped triangles, and farther for flat ones. The interval may have any width.
ResolvedPair resolvePair(const PairQuery& query, const TrianglesAt& triangles);

/// Whether a pair touches, as far as double can tell.
struct ContactInDouble {
    Verdict contact;
    Vector3 apartAlong;  ///< the direction that proves the gap, not of unit length
};

/// Decides contact exactly as resolvePair does (up to last-digit differences in what stays open), but
/// computes no distance and no closest points.
ContactInDouble contactOf(const PairQuery& query, const TrianglesAt& triangles);

}  // namespace clearway
