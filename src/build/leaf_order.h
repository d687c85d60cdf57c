// The mesh in the order of a tree's leaves, so that everything below a node lies together.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/clean.h"
#include "tree/binary_tree.h"

namespace clearway {

/// Triangles in the order of the leaves, vertices in the order of their first use. The vertices of a run of
/// triangles are then a run too, except for those it shares with triangles before it.
class LeafOrder {
  public:
    LeafOrder(const CleanMesh& mesh, const std::vector<std::uint32_t>& order);

    /// Reused from run to run for its storage.
    struct Gathered {
        std::vector<Vector3> points;
        std::vector<std::uint32_t> earlier;  ///< the vertices that triangles before the run use too
    };

    /// Replaces `gathered` by the distinct vertices of `count` triangles from `first` on.
    void gatherVertices(std::uint32_t first, std::uint32_t count, Gathered& gathered) const;

    const std::vector<Vector3>& vertices() const { return vertices_; }
    const std::vector<TriangleIndices>& triangles() const { return triangles_; }

  private:
    std::vector<Vector3> vertices_;
    std::vector<TriangleIndices> triangles_;
    std::vector<std::uint32_t> verticesBefore_;  ///< for each triangle, the number of vertices used before it
};

}  // namespace clearway
