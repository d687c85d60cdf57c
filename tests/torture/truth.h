// The exact answer to a small case, and the lengths that its answers are measured in.
#pragma once

#include "support/exact_distance.h"
#include "torture/pair_families.h"

namespace clearway::testing {

/// Every triangle of the one against every one of the other.
ExactDistance exactDistance(const PosedMeshes& posed);

/// From the triangle of the part at its pose, or of the environment, to a point.
ExactDistance exactlyFromPart(const PosedMeshes& posed, std::size_t triangle, const Vector3& point);
ExactDistance exactlyFromEnvironment(const PosedMeshes& posed, std::size_t triangle, const Vector3& point);

struct CaseLengths {
    double largest = 0;    ///< M: of both meshes' coordinates, the moved part's and the pose's translation
    double edge = 0;       ///< L: the longest
    double scene = 0;      ///< diagonals of both boxes, each in its own coordinates
    double leastSize = 0;  ///< diagonal of the smaller box that is no point, or a denormal coordinate
    double flattest = 1;   ///< least height over longest edge of a triangle; 0 for one without area
};

CaseLengths lengthsOf(const PosedMeshes& posed);

}  // namespace clearway::testing
