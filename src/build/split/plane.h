// The side of a plane a triangle's centroid lies on.
#pragma once

#include <algorithm>
#include <cstddef>

#include "build/triangle_run.h"

namespace clearway {

struct Plane {
    Vector3 point;
    Vector3 normal;
};

inline bool liesBeyond(const CleanMesh& mesh, std::uint32_t triangle, const Plane& plane) {
    return plane.normal.dot(tripleCentroid(mesh, triangle, plane.point)) > 0;
}

/// Puts the triangles beyond the plane last and returns how many are not.
inline std::size_t partitionByPlane(const CleanMesh& mesh, TriangleRun run, const Plane& plane) {
    const auto isLeft = [&](std::uint32_t triangle) { return !liesBeyond(mesh, triangle, plane); };
    return static_cast<std::size_t>(std::partition(run.first, run.last, isLeft) - run.first);
}

}  // namespace clearway
