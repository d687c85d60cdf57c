#include "build/leaf_order.h"

#include <algorithm>

#include "mesh/renumber.h"

namespace clearway {

namespace {

/// Up to this many vertices from before a run are looked through for one that comes again.
constexpr std::size_t kFewEarlier = 24;

}  // namespace

LeafOrder::LeafOrder(const CleanMesh& mesh, const std::vector<std::uint32_t>& order) {
    FirstUseOrder numberOf(mesh.vertices.size());
    for (LargeVector<double>& coordinates : vertices_) coordinates.reserve(mesh.vertices.size());
    triangles_.reserve(order.size());
    verticesBefore_.reserve(order.size() + 1);
    for (const std::uint32_t triangle : order) {
        verticesBefore_.push_back(static_cast<std::uint32_t>(vertexCount()));
        TriangleIndices indices = mesh.triangles[triangle];
        for (std::uint32_t& vertex : indices) {
            vertex = numberOf(vertex, [&](std::uint32_t used) {
                for (std::size_t k = 0; k < 3; ++k)
                    vertices_[k].push_back(mesh.vertices[used][Eigen::Index(k)]);
            });
        }
        triangles_.push_back(indices);
    }
    verticesBefore_.push_back(static_cast<std::uint32_t>(vertexCount()));
}

std::size_t LeafOrder::gatherVertices(std::uint32_t first, std::uint32_t count, PointArrays& points) const {
    const std::uint32_t firstOwn = verticesBefore_[first];
    const std::size_t own = verticesBefore_[first + count] - firstOwn;
    const std::size_t most = own + 3 * std::size_t(count);
    for (std::size_t k = 0; k < 3; ++k) {
        std::copy_n(vertices_[k].begin() + firstOwn, own, points[k].withRoomFor(most));
    }
    const std::uint32_t* indices = triangles_[first].data();
    std::uint32_t few[kFewEarlier];
    std::size_t end = own;
    for (std::size_t i = 0; i < 3 * std::size_t(count); ++i) {
        const std::uint32_t vertex = indices[i];
        if (vertex >= firstOwn) continue;
        const std::size_t seen = std::min(end - own, kFewEarlier);
        if (std::find(few, few + seen, vertex) != few + seen) continue;
        if (seen < kFewEarlier) few[seen] = vertex;
        for (std::size_t k = 0; k < 3; ++k) points[k].data()[end] = vertices_[k][vertex];
        ++end;
    }
    return end;
}

}  // namespace clearway
