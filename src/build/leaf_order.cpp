#include "build/leaf_order.h"

#include <algorithm>

#include "mesh/renumber.h"

namespace clearway {

LeafOrder::LeafOrder(const CleanMesh& mesh, const std::vector<std::uint32_t>& order) {
    FirstUseOrder numberOf(mesh.vertices.size());
    vertices_.reserve(mesh.vertices.size());
    triangles_.reserve(order.size());
    verticesBefore_.reserve(order.size() + 1);
    for (const std::uint32_t triangle : order) {
        verticesBefore_.push_back(static_cast<std::uint32_t>(vertices_.size()));
        TriangleIndices indices = mesh.triangles[triangle];
        for (std::uint32_t& vertex : indices) {
            vertex = numberOf(vertex, [&](std::uint32_t used) { vertices_.push_back(mesh.vertices[used]); });
        }
        triangles_.push_back(indices);
    }
    verticesBefore_.push_back(static_cast<std::uint32_t>(vertices_.size()));
}

void LeafOrder::gatherVertices(std::uint32_t first, std::uint32_t count, Gathered& gathered) const {
    auto& [points, earlier] = gathered;
    const std::uint32_t firstOwn = verticesBefore_[first];
    const std::uint32_t endOwn = verticesBefore_[first + count];
    earlier.clear();
    for (std::uint32_t i = first; i < first + count; ++i) {
        for (const std::uint32_t vertex : triangles_[i]) {
            if (vertex < firstOwn) earlier.push_back(vertex);
        }
    }
    std::sort(earlier.begin(), earlier.end());
    earlier.erase(std::unique(earlier.begin(), earlier.end()), earlier.end());
    points.assign(vertices_.begin() + firstOwn, vertices_.begin() + endOwn);
    for (const std::uint32_t vertex : earlier) points.push_back(vertices_[vertex]);
}

}  // namespace clearway
