// The two triangles of a pair where the pose puts them, and the points of theirs that an answer names.
#pragma once

#include <cstdint>

#include "clearway/types.h"
#include "query/pair_query.h"

namespace clearway {

constexpr std::int32_t kNoFeature = -1;

/// Two triangles, by their positions in the trees, and where they are closest, as far as is known.
struct TrianglesAt {
    std::uint32_t part;
    std::uint32_t environment;
    std::int32_t feature;  ///< a guess, which costs time alone when it is wrong, or kNoFeature
};

/// A triangle's corners, query units, environment frame.
struct Corners {
    Vector3 p[3];
    Vector3 edge(int k) const { return p[(k + 1) % 3] - p[k]; }
    Vector3 normal() const { return edge(0).cross(p[2] - p[0]); }
};

/// The part's triangle as moved, each coordinate rounded once, and the environment's.
Corners movedCorners(const PairQuery& query, std::uint32_t triangle);
Corners fixedCorners(const PairQuery& query, std::uint32_t triangle);

/// A point of a triangle: corner + s (next corner - corner) + t (last corner - corner); s, t, s + t in 0..1.
struct PlaceInTriangle {
    int corner = 0;
    double s = 0, t = 0;
};

/// The point: off its triangle by at most 3.6 u64 of its largest coordinate, half of that on an edge.
Vector3 pointAt(const PlaceInTriangle& place, const Corners& triangle);

/// |p - q|, off by at most 1.5 u64 of itself.
double lengthBetween(const Vector3& p, const Vector3& q);

/// >= the distance of the triangles of which p and q are points. Each of the two is off its true triangle by
/// at most: the part's rounded corners 1.8 u64 M; a point within an edge 1.8, two of them at most; a corner 0
/// and its point on a face 3.6.
inline double upperBoundFrom(const Vector3& p, const Vector3& q, double M) {
    constexpr double kPointRoundoffs = 6;
    return lengthBetween(p, q) * (1 + 2 * kUnitRoundoffDouble) + kPointRoundoffs * kUnitRoundoffDouble * M;
}

}  // namespace clearway
