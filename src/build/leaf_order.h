// The mesh in the order of a tree's leaves, so that what lies below a node lies together.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/clean.h"
#include "tree/binary_tree.h"

namespace clearway {

/// Triangles in the order of the leaves, vertices in that of their first use. The vertices of a run of
/// triangles then are a run, too, but for those it shares with triangles before it.
class LeafOrder {
  public:
    LeafOrder(const CleanMesh& mesh, const std::vector<std::uint32_t>& order);

    /// Kept from run to run for its storage.
    struct Gathered {
        std::vector<Vector3> points;
        std::vector<std::uint32_t>
            earlier;  ///< of the vertices, those that triangles before the run have, too
    };

    /// The distinct vertices of count triangles from first, in place of what was gathered before.
    void gatherVertices(std::uint32_t first, std::uint32_t count, Gathered& gathered) const;

    const std::vector<Vector3>& vertices() const { return vertices_; }
    const std::vector<TriangleIndices>& triangles() const { return triangles_; }

  private:
    std::vector<Vector3> vertices_;
    std::vector<TriangleIndices> triangles_;
    std::vector<std::uint32_t> verticesBefore_;  ///< of each triangle: the number used by those before it
};

}  // namespace clearway
