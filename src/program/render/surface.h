// A mesh for pictures: in floats, with normals that are smooth except at creases.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "clearway/mesh.h"

namespace clearway::render {

using Vector3f = Eigen::Vector3f;

struct Surface {
    std::vector<Vector3f> vertices;
    std::vector<TriangleIndices> triangles;
    std::vector<std::array<Vector3f, 3>> normals;  ///< at the corners of each triangle, unit length
    std::vector<std::uint32_t> components;         ///< component of each triangle in the mesh
};

/// Cuts away all points x with normal . x > offset.
struct CutPlane {
    Vector3 normal = Vector3::UnitZ();  ///< unit length
    double offset = 0;
};

/// Maps mesh coordinates to (coordinates - origin) * scale. Throws as Model::build does for a broken mesh.
Surface surfaceOf(const Mesh& mesh, const Vector3& origin, double scale);

/// The rest of the surface; triangles across the plane are cut in two. The plane is in the surface's
/// coordinates.
Surface cutBy(const CutPlane& plane, const Surface& surface);

/// A tube along the points, which shows a line. Component i goes from point i to point i + 1.
Surface tubeAlong(const std::vector<Vector3f>& points, float radius);

}  // namespace clearway::render
