// A mesh small enough for a page: welded, thinned out if need be, its coordinates in 16 bits.
// Source: Rossignac, Borrel, Multi-Resolution 3D Approximations for Rendering Complex Scenes, 1993
// (thinning).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "clearway/mesh.h"

namespace clearway::report {

struct PageMesh {
    Box box;                                              ///< in the mesh's coordinates
    std::vector<std::array<std::uint16_t, 3>> positions;  ///< 0 to 65535 along the box
    std::vector<TriangleIndices> triangles;
    double error = 0;  ///< no vertex is shown further from where it is; mesh units
};

/// All the triangles when they are at most so many; else vertices in cells of a grid become one, the
/// triangles that this leaves without an area are left out, and the cells are as small as the number allows.
/// Throws what Model::build throws for a mesh that is not sound.
PageMesh pageMeshOf(const Mesh& mesh, std::size_t mostTriangles);

}  // namespace clearway::report
