// The mesh in the order of a tree's leaves, so that everything below a node lies together.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "build/scratch_array.h"
#include "core/large_vector.h"
#include "mesh/clean.h"
#include "tree/binary_tree.h"

namespace clearway {

/// Points in double as structure of arrays.
using PointArrays = std::array<ScratchArray<double>, 3>;

/// Triangles in the order of the leaves, vertices in the order of their first use. The vertices of a run of
/// triangles are then a run too, except for those it shares with triangles before it.
class LeafOrder {
  public:
    LeafOrder(const CleanMesh& mesh, const std::vector<std::uint32_t>& order);

    /// Replaces `points` by the vertices of `count` triangles from `first` on, in mesh coordinates. The vertices that triangles
    /// before the run use too may come several times if there are many. The arrays may be larger: returns the number of points.
    std::size_t gatherVertices(std::uint32_t first, std::uint32_t count, PointArrays& points) const;

    /// Mesh coordinates.
    Vector3 vertex(std::uint32_t number) const {
        return {vertices_[0][number], vertices_[1][number], vertices_[2][number]};
    }
    std::size_t vertexCount() const { return vertices_[0].size(); }
    const std::vector<TriangleIndices>& triangles() const { return triangles_; }

  private:
    std::array<LargeVector<double>, 3> vertices_;
    std::vector<TriangleIndices> triangles_;
    std::vector<std::uint32_t> verticesBefore_;  ///< for each triangle, the number of vertices used before it
};

}  // namespace clearway
