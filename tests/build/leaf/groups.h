// Hand-made groups of triangles, given by vertex numbers alone, and the leaves a leaf split makes of them.
#pragma once

#include <cstdint>
#include <numeric>
#include <vector>

#include "build/leaf_splits.h"

namespace clearway::testing {

/// Vertices in general position; leaf splits look at the numbers only.
inline CleanMesh meshOf(const std::vector<TriangleIndices>& triangles) {
    CleanMesh mesh;
    mesh.triangles = triangles;
    for (std::uint32_t i = 0; i < triangles.size(); ++i) mesh.triangleIds.push_back(i);
    for (int i = 0; i < 64; ++i) mesh.vertices.push_back(Vector3(i, i * i % 17, i * i * i % 23));
    return mesh;
}

using Leaves = std::vector<std::vector<std::uint32_t>>;

/// The leaves from left to right, each with its triangles in order.
inline Leaves leavesOf(const BinaryTree& tree) {
    Leaves leaves;
    std::vector<std::int32_t> pending{0};
    while (!pending.empty()) {
        const BinaryNode& node = tree.nodes.at(pending.back());
        pending.pop_back();
        if (node.isLeaf()) {
            const auto first = tree.order.begin() + node.firstTriangle;
            leaves.emplace_back(first, first + node.triangleCount);
        } else {
            pending.push_back(node.right);
            pending.push_back(node.left);
        }
    }
    return leaves;
}

/// Splits the whole mesh as one group.
inline BinaryTree splitGroup(GroupSplit split, const CleanMesh& mesh) {
    std::vector<std::uint32_t> group(mesh.triangles.size());
    std::iota(group.begin(), group.end(), 0u);
    return split(mesh, group, buildByMeanSplit);
}

}  // namespace clearway::testing
