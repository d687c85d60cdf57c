// The leaf splits of the table. Chains are grown from triangle to triangle and then halved into a small tree.
#include "build/leaf_splits.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

namespace clearway {

namespace {

int countSharedVertices(const TriangleIndices& a, const TriangleIndices& b) {
    int shared = 0;
    for (int i = 0; i < 3; ++i) {
        const bool seenBefore =
            std::find(a.begin(), a.begin() + i, a[i]) != a.begin() + i;  // degenerate triangles
        if (!seenBefore && std::find(b.begin(), b.end(), a[i]) != b.end()) ++shared;
    }
    return shared;
}

struct Chains {
    std::vector<std::uint32_t> triangles;  ///< chain after chain
    std::vector<std::size_t> ends;         ///< of each chain, into triangles
};

/// Divides the group into chains. A chain starts at the first free triangle and grows by every free triangle
/// that shares at least sharedVertices distinct vertices with one in the chain (by index: the mesh is
/// welded), until none is left.
Chains growChains(const CleanMesh& mesh, std::vector<std::uint32_t> group, int sharedVertices) {
    Chains chains{std::move(group), {}};
    std::vector<std::uint32_t>& triangles = chains.triangles;
    std::size_t chainEnd = 0;
    while (chainEnd < triangles.size()) {
        // The chain ends at chainEnd; the triangles after it are free. Each link looks once for free
        // neighbours.
        std::size_t link = chainEnd++;
        for (; link < chainEnd; ++link) {
            for (std::size_t free = chainEnd; free < triangles.size(); ++free) {
                if (countSharedVertices(mesh.triangles[triangles[link]], mesh.triangles[triangles[free]]) <
                    sharedVertices)
                    continue;
                // Rotated rather than swapped, so that the free triangles keep their order.
                std::rotate(triangles.begin() + chainEnd, triangles.begin() + free,
                            triangles.begin() + free + 1);
                ++chainEnd;
            }
        }
        chains.ends.push_back(chainEnd);
    }
    return chains;
}

/// The topology with one leaf for each chain, halving the list of chains from node to node.
BinaryTree treeOfChains(const Chains& chains) {
    struct Pending {
        std::size_t node, firstChain, lastChain;
    };
    BinaryTree tree;
    tree.order = chains.triangles;
    tree.nodes.emplace_back();
    std::vector<Pending> pending{{0, 0, chains.ends.size()}};
    while (!pending.empty()) {
        const auto [node, firstChain, lastChain] = pending.back();
        pending.pop_back();
        const std::size_t start = firstChain == 0 ? 0 : chains.ends[firstChain - 1];
        tree.nodes[node].firstTriangle = static_cast<std::uint32_t>(start);
        tree.nodes[node].triangleCount = static_cast<std::uint32_t>(chains.ends[lastChain - 1] - start);
        if (lastChain - firstChain == 1) continue;

        const std::size_t middle = (firstChain + lastChain + 1) / 2;
        const std::size_t left = tree.nodes.size();
        tree.nodes[node].left = static_cast<std::int32_t>(left);
        tree.nodes[node].right = static_cast<std::int32_t>(left + 1);
        tree.nodes.resize(left + 2);
        pending.push_back({left + 1, middle, lastChain});
        pending.push_back({left, firstChain, middle});
    }
    return tree;
}

/// The group as a mesh of its own. General splits look at the whole mesh before they begin; with thousands of
/// groups they would do so thousands of times.
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

BinaryTree keepTogether(const CleanMesh&, std::vector<std::uint32_t> group, GeneralSplit) {
    BinaryTree tree;
    tree.nodes.emplace_back();
    tree.nodes.front().triangleCount = static_cast<std::uint32_t>(group.size());
    tree.order = std::move(group);
    return tree;
}

BinaryTree splitIntoVertexChains(const CleanMesh& mesh, std::vector<std::uint32_t> group, GeneralSplit) {
    return treeOfChains(growChains(mesh, std::move(group), 1));
}

BinaryTree splitIntoEdgeChains(const CleanMesh& mesh, std::vector<std::uint32_t> group, GeneralSplit) {
    return treeOfChains(growChains(mesh, std::move(group), 2));
}

BinaryTree splitIntoSingles(const CleanMesh& mesh, std::vector<std::uint32_t> group, GeneralSplit general) {
    const CleanMesh own = meshOfGroup(mesh, group);
    std::vector<std::uint32_t> all(group.size());
    std::iota(all.begin(), all.end(), 0u);
    BinaryTree tree = general(own, std::move(all), 1);
    for (std::uint32_t& triangle : tree.order) triangle = group[triangle];
    return tree;
}

}  // namespace clearway
