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
/// too much. Worst case 138; src/kernels/rounding.md adds it up.
constexpr double kVolumeSlack = 160;

/// Rounding of one gap or distance between triangles, in u32 (leaf radius + leaf radius + |offset|). Worst
/// case 19, likewise.
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
