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

/// Lets the general split go on below a group, down to smaller ones.
BinaryTree goOn(const CleanMesh& mesh, const std::vector<std::uint32_t>& group, GeneralSplit general,
                std::size_t largestGroup) {
    const CleanMesh own = meshOfGroup(mesh, group);
    std::vector<std::uint32_t> all(group.size());
    std::iota(all.begin(), all.end(), 0u);
    BinaryTree tree = general(own, std::move(all), largestGroup);
    for (std::uint32_t& triangle : tree.order) triangle = group[triangle];
    return tree;
}

/// Replaces a leaf by a small tree over its triangles.
void graft(BinaryTree& tree, std::size_t leaf, const BinaryTree& branch) {
    const FrameAxes axes = tree.nodes[leaf].axes;
    const std::uint32_t firstTriangle = tree.nodes[leaf].firstTriangle;
    std::copy(branch.order.begin(), branch.order.end(), tree.order.begin() + firstTriangle);
    // The branch's root takes the leaf's place; its other nodes go to the end.
    const std::int32_t shift = static_cast<std::int32_t>(tree.nodes.size()) - 1;
    for (std::size_t i = 0; i < branch.nodes.size(); ++i) {
        BinaryNode node = branch.nodes[i];
        node.firstTriangle += firstTriangle;
        node.axes = axes;
        node.area = kNotRated;  // its area is in the branch's unit
        if (!node.isLeaf()) {
            node.left += shift;
            node.right += shift;
        }
        if (i == 0) {
            tree.nodes[leaf] = node;
        } else {
            tree.nodes.push_back(node);
        }
    }
}

}  // namespace

void splitEachGroup(BinaryTree& tree, const CleanMesh& mesh, GeneralSplit general, GroupSplit split) {
    const std::size_t count = tree.nodes.size();
    for (std::size_t i = 0; i < count; ++i) {
        if (!tree.nodes[i].isLeaf()) continue;
        const auto first = tree.order.begin() + tree.nodes[i].firstTriangle;
        graft(tree, i, split(mesh, {first, first + tree.nodes[i].triangleCount}, general));
    }
}

void keepTogether(BinaryTree&, const CleanMesh&, GeneralSplit) {}

BinaryTree splitIntoVertexChains(const CleanMesh& mesh, std::vector<std::uint32_t> group, GeneralSplit) {
    return treeOfChains(growChains(mesh, std::move(group), 1));
}

BinaryTree splitIntoEdgeChains(const CleanMesh& mesh, std::vector<std::uint32_t> group, GeneralSplit) {
    return treeOfChains(growChains(mesh, std::move(group), 2));
}

BinaryTree splitIntoSingles(const CleanMesh& mesh, std::vector<std::uint32_t> group, GeneralSplit general) {
    return goOn(mesh, group, general, 1);
}

BinaryTree splitIntoSmallGroups(const CleanMesh& mesh, std::vector<std::uint32_t> group,
                                GeneralSplit general) {
    return goOn(mesh, group, general, kMostByCost);
}

}  // namespace clearway
