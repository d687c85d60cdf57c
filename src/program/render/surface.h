// A mesh as pictures need it: in floats, with normals that are smooth but for creases.
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
    std::vector<std::array<Vector3f, 3>> normals;  ///< of each triangle's corners, unit length
    std::vector<std::uint32_t> components;         ///< of each triangle, as in the mesh
};

/// What lies on the side of the plane that `normal` points to is cut away: x with normal . x > offset.
struct CutPlane {
    Vector3 normal = Vector3::UnitZ();  ///< unit length
    double offset = 0;
};

/// Coordinates are (mesh coordinates - origin) * scale. Throws what Model::build throws for a mesh that is
/// not sound.
Surface surfaceOf(const Mesh& mesh, const Vector3& origin, double scale);

/// What the plane leaves, triangles across it cut in two. The plane is in the surface's coordinates.
Surface cutBy(const CutPlane& plane, const Surface& surface);

/// A tube of the given radius along the points, for a line that can be seen; component i goes from point i
/// to i + 1.
Surface tubeAlong(const std::vector<Vector3f>& points, float radius);

}  // namespace clearway::render
