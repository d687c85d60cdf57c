// A mesh small enough for a page: welded, simplified if necessary, with coordinates of 16 bits and feature edges.
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
    std::vector<TriangleIndices> triangles;               ///< in the order of the mesh's components
    std::vector<std::array<std::uint32_t, 2>> edges;      ///< see featureEdges(); in the same order
    /// How many triangles and edges belong to each component of the mesh.
    std::vector<std::uint32_t> triangleCounts, edgeCounts;
    std::size_t allEdges = 0;  ///< also those left out
    double error = 0;          ///< largest displacement of a vertex, mesh units

    /// Mesh coordinates of a stored position.
    Vector3 placeOf(const std::array<std::uint16_t, 3>& stored) const {
        constexpr double kSteps = 65535;  // of a coordinate along the box
        return box.min() + Vector3(stored[0], stored[1], stored[2]).cwiseProduct(box.diagonal()) / kSteps;
    }
};

struct PageMeshLimits {
    std::size_t triangles = 0, edges = 0;
};

/// Keeps all triangles when the limit allows. Otherwise merges the vertices in each cell of a grid, drops the
/// triangles that become degenerate, and makes the cells as small as the limit allows. Of too many edges it keeps
/// the longest. Throws as Model::build does for a broken mesh.
PageMesh pageMeshOf(const Mesh& mesh, const PageMeshLimits& most);

}  // namespace clearway::report
