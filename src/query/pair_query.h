// One query made ready for traversal: the pose composed in double, then rounded once, and the error terms
// that the rounding costs. All lengths of a query are in its unit, 2^unitExponent, the larger of the two
// trees' units.
#pragma once

#include <cmath>
#include <limits>

#include "clearway/types.h"
#include "tree/flat_tree.h"

namespace clearway {

constexpr double kUnitRoundoffFloat = 0x1p-24;
constexpr double kUnitRoundoffDouble = 0x1p-53;

/// Rounding of one bound between volumes, in u32 (|t| + radius + radius): what the float kernel may answer
/// too much. First order, worst case, u = u32, Q = |t| + both radii about their trees' origins:
///   volume carried over: rounded rotation and 6 operations per coordinate, rounded t       13.2 u Q
///   its axes off by 7 u each, so its rectangle by 7 u (h0 + h1)                             10 u Q
///   box gaps in axes that are orthonormal only to 15 u: extents 20, their length 30         50 u Q
///   difference of centres, projections, extents, lengths and the sum of radii               19 u Q
/// The rotation's own defect, at most 3e-12 Q, is a ten-thousandth of this.
constexpr double kVolumeSlack = 96;

/// Rounding of one gap or distance between triangles, in u32 (leaf radius + leaf radius + |offset|), first
/// order, by what it costs the part's radius, which it costs most:
///   a corner: stored 1, rotation 1.7, 6 operations per coordinate (3 where they are fused) 6.7         9.4
///   a slab gap: products 3, their difference 1, length and division 3.5, this error taken off 1         8.5
///   or the distance of two points: corners' difference and two sums 3, edges 2, multiples of them 2,
///   shares that add up to more than 1 by a rounding 2, length 2.5, this error added 1                  12.5
constexpr double kTriangleSlack = 24;

/// Composing R c + t - c' in double from coordinates of at most M, in u64 M: 3 products, 3 sums, 3
/// coordinates.
constexpr double kOffsetSlack = 20;

/// What float does not prove farther apart than this (query units) is left to double: the squares by which
/// float compares would vanish far below.
constexpr float kLeastProved = 0x1p-22f;

/// How volumes of one tree come into the frame and unit of the other's nodes: x -> ratio * (R x) + t.
struct alignas(16) Carry {
    float columns[3][4];   ///< of R, and a 0 at the end of each
    float translation[4];  ///< t and a 0
    float ratio;           ///< exact power of two
    float slack;           ///< kVolumeSlack's term, in the target tree's unit
    float toQueryUnit;     ///< target tree's unit -> query unit, exact power of two
};

/// The least float above x. x: below the largest float.
inline float nextFloatAbove(double x) {
    const float rounded = static_cast<float>(x);
    return rounded > x ? rounded : std::nextafter(rounded, std::numeric_limits<float>::infinity());
}

struct PairQuery {
    const FlatTree* part;
    const FlatTree* environment;
    Carry partToEnvironment;
    Carry environmentToPart;

    double R[9];         ///< X_environmentPart as given, row-major
    double t[3];         ///< mesh units
    double perMeshUnit;  ///< 2^-unitExponent: mesh units -> query units
    int unitExponent;
    float rotation[9];      ///< R rounded
    float partLeafToQuery;  ///< the trees' units -> query unit
    float environmentLeafToQuery;
    double offsetSlack;  ///< kOffsetSlack's term, query units

    double largestCoordinate;  ///< M: of both meshes' vertices, the moved part's and t; query units
    double defaultWidth;       ///< of an answer's interval: 1e-12 of the scene size and 32 u64 M
};

/// Throws std::invalid_argument when the pose is no rotation, or the sizes of the two meshes or the way
/// between them differ by more than 2^60.
PairQuery preparePairQuery(const FlatTree& part, const FlatTree& environment, const Pose& X_environmentPart);

}  // namespace clearway
