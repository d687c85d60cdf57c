// Is a surface closed? Every edge must be shared by exactly two triangles that run along it in opposite
// directions.
#pragma once

#include <cstddef>
#include <vector>

#include "clearway/mesh.h"

namespace clearway {

/// Edges between vertices, by how the triangles meet there. Each edge is counted once.
struct EdgeReport {
    std::size_t closedEdges = 0;    ///< two triangles, opposite directions
    std::size_t openEdges = 0;      ///< one triangle: a border
    std::size_t twistedEdges = 0;   ///< two triangles, same direction: one of them is turned over
    std::size_t overfullEdges = 0;  ///< three triangles or more

    bool isClosed() const { return openEdges == 0 && twistedEdges == 0 && overfullEdges == 0; }
};

/// The triangles' vertices must be welded: equal points, equal indices. A triangle that names a vertex twice
/// is left out: it has collapsed to an edge that its two neighbours then share.
EdgeReport checkEdges(const std::vector<TriangleIndices>& triangles);

}  // namespace clearway
