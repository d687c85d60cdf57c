// The centre of a leaf, chosen so that, if it can be, centre plus float offset is each vertex exactly. Such a leaf needs
// no vertices in double. Where vertices are floats, as files hold them, it can be in nearly every leaf: a difference of
// floats is a float if both are within a factor of 2 or are multiples of a grid that is coarse enough, and the others lie
// near 0, which is then the centre's coordinate.
#pragma once

#include <array>
#include <cstddef>

#include "clearway/build_options.h"
#include "clearway/types.h"

namespace clearway {

/// The corners of a leaf's triangles by axis, mesh coordinates.
struct LeafCorners {
    double at[3][3 * kLargestLeafSize];
    std::size_t count = 0;

    void add(const Vector3& corner) {
        for (int k = 0; k < 3; ++k) at[k][count] = corner[k];
        ++count;
    }
    Vector3 corner(std::size_t i) const { return {at[0][i], at[1][i], at[2][i]}; }
};

struct LeafCentre {
    std::array<float, 3> stored;  ///< (point - tree's origin) / unit, rounded
    Vector3 point;                ///< leafCentre of `stored`, mesh coordinates
    bool isExact;  ///< whether point + unit * leafOffset is each corner exactly, as computed in double
};

/// Chooses the centre near the middle of the corners' box. Where a coordinate is 0 to make the leaf exact, the
/// corners' largest distance from the centre may grow up to fourfold. origin, unit: the tree's.
LeafCentre chooseLeafCentre(const LeafCorners& corners, const Vector3& origin, double unit);

/// A corner's coordinate less the centre's, in tree units, rounded to float. inverseUnit: of the tree's unit, a power of two.
inline float leafOffset(double corner, double centre, double inverseUnit) {
    return static_cast<float>((corner - centre) * inverseUnit);
}

}  // namespace clearway
