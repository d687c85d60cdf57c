// Moves points to coordinates within +-1, so that no squared coordinate overflows or vanishes at any scale of
// the mesh.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include "clearway/types.h"

namespace clearway {

/// x -> (x - middle) / unit. The unit is a power of two, so results scale back exactly.
struct Normalisation {
    Vector3 middle = Vector3::Zero();
    double unit = 1;
    double inverseUnit = 1;

    Vector3 operator()(const Vector3& point) const { return (point - middle) * inverseUnit; }
};

/// Maps the middle of the points' box to 0 and its longest side to a length in [1, 2), or to 0 when all
/// points are equal.
inline Normalisation normalisationOf(const std::vector<Vector3>& points) {
    assert(!points.empty());
    Vector3 lowest = points.front();
    Vector3 highest = points.front();
    for (const Vector3& point : points) {
        lowest = lowest.cwiseMin(point);
        highest = highest.cwiseMax(point);
    }
    Normalisation normalisation;
    normalisation.middle = 0.5 * lowest + 0.5 * highest;
    const double halfExtent = (0.5 * highest - 0.5 * lowest).maxCoeff();
    if (halfExtent > 0) {
        const int exponent = std::clamp(std::ilogb(halfExtent) + 1, -1000, 1000);  // keeps the inverse finite
        normalisation.unit = std::ldexp(1.0, exponent);
        normalisation.inverseUnit = std::ldexp(1.0, -exponent);
    }
    return normalisation;
}

}  // namespace clearway
