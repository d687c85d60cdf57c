#include "build/leaf/all.h"

#include <numeric>
#include <utility>

namespace clearway {

namespace {

/// General splits look at all of a mesh before they begin. With thousands of groups that would be all of it
/// thousands of times: so each group is a mesh of its own.
CleanMesh meshOfGroup(const CleanMesh& mesh, const std::vector<std::uint32_t>& group) {
    CleanMesh own;
    for (const std::uint32_t triangle : group) {
        TriangleIndices indices;
        for (std::size_t k = 0; k < 3; ++k) {
            indices[k] = static_cast<std::uint32_t>(own.vertices.size());
            own.vertices.push_back(mesh.vertices[mesh.triangles[triangle][k]]);
        }
        own.triangles.push_back(indices);
        own.triangleIds.push_back(mesh.triangleIds[triangle]);
    }
    return own;
}

}  // namespace

BinaryTree splitIntoSingles(const CleanMesh& mesh, std::vector<std::uint32_t> group, GeneralSplit general) {
    const CleanMesh own = meshOfGroup(mesh, group);
    std::vector<std::uint32_t> all(group.size());
    std::iota(all.begin(), all.end(), 0u);
    BinaryTree tree = general(own, std::move(all), 1);
    for (std::uint32_t& triangle : tree.order) triangle = group[triangle];
    return tree;
}

}  // namespace clearway
