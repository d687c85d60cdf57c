// The exact answer to a small case, and the lengths in which answers are measured.
#pragma once

#include "support/exact_distance.h"
#include "torture/pair_families.h"

namespace clearway::testing {

/// The distance between all triangles of one mesh and all of the other.
ExactDistance exactDistance(const PosedMeshes& posed);

/// The distance of a point from a triangle of the part at its pose, or of the environment.
ExactDistance exactlyFromPart(const PosedMeshes& posed, std::size_t triangle, const Vector3& point);
ExactDistance exactlyFromEnvironment(const PosedMeshes& posed, std::size_t triangle, const Vector3& point);

struct CaseLengths {
    double largest = 0;    ///< M: largest coordinate of both meshes, the moved part and the translation
    double edge = 0;       ///< L: the longest edge
    double scene = 0;      ///< sum of the diagonals of both boxes, each in its own coordinates
    double leastSize = 0;  ///< diagonal of the smaller box that is not a point, or a denormal coordinate
    double flattest = 1;   ///< least height over longest edge of any triangle; 0 for one without area
};

CaseLengths lengthsOf(const PosedMeshes& posed);

}  // namespace clearway::testing
