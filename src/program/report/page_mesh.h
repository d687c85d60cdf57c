// A mesh small enough for a page: welded, simplified if necessary, with coordinates of 16 bits.
// Source: Rossignac, Borrel, Multi-Resolution 3D Approximations for Rendering Complex Scenes, 1993
// (the simplification).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "clearway/mesh.h"

namespace clearway::report {

struct PageMesh {
    Box box;                                              ///< mesh coordinates
    std::vector<std::array<std::uint16_t, 3>> positions;  ///< 0 to 65535 along the box
    std::vector<TriangleIndices> triangles;
    double error = 0;  ///< largest displacement of a vertex, mesh units
};

/// Keeps all triangles when there are at most `mostTriangles`. Otherwise merges the vertices in each cell of
/// a grid, drops the triangles that become degenerate, and makes the cells as small as the limit allows.
/// Throws as Model::build does for a broken mesh.
PageMesh pageMeshOf(const Mesh& mesh, std::size_t mostTriangles);

}  // namespace clearway::report
