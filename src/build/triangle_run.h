// A run of triangles within the order a build arranges: what a split looks at and rearranges.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "clearway/types.h"
#include "mesh/clean.h"

namespace clearway {

/// Positions of triangles in CleanMesh::triangles, not owned.
struct TriangleRun {
    std::uint32_t* first;
    std::uint32_t* last;  ///< one past the end

    std::uint32_t* begin() const { return first; }
    std::uint32_t* end() const { return last; }
    std::size_t size() const { return static_cast<std::size_t>(last - first); }
};

/// Appends the three corners of a triangle. A vertex that several triangles share comes once for each.
inline void appendCorners(const CleanMesh& mesh, std::uint32_t triangle, std::vector<Vector3>& corners) {
    for (const std::uint32_t vertex : mesh.triangles[triangle]) corners.push_back(mesh.vertices[vertex]);
}

/// The corners of count triangles in place of what the vector held.
inline void gatherCorners(const CleanMesh& mesh, const std::uint32_t* triangles, std::size_t count,
                          std::vector<Vector3>& corners) {
    corners.clear();
    for (std::size_t i = 0; i < count; ++i) appendCorners(mesh, triangles[i], corners);
}

/// Three times the triangle's centroid, relative to a point: exact enough to compare where the point is near.
inline Vector3 tripleCentroid(const CleanMesh& mesh, std::uint32_t triangle, const Vector3& relativeTo) {
    const auto& [a, b, c] = mesh.triangles[triangle];
    return (mesh.vertices[a] - relativeTo) + (mesh.vertices[b] - relativeTo) +
           (mesh.vertices[c] - relativeTo);
}

}  // namespace clearway
