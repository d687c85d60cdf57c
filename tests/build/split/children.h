// The triangles that a general split puts on the two sides of the root.
#pragma once

#include <cstdint>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include "build/general_splits.h"

namespace clearway::testing {

using TriangleSet = std::set<std::uint32_t>;

inline TriangleSet trianglesOf(const BinaryTree& tree, std::int32_t node) {
    const auto first = tree.order.begin() + tree.nodes.at(node).firstTriangle;
    return {first, first + tree.nodes[node].triangleCount};
}

/// The two sides, the one with triangle 0 first.
inline std::pair<TriangleSet, TriangleSet> rootChildren(GeneralSplit split, const CleanMesh& mesh) {
    std::vector<std::uint32_t> all(mesh.triangles.size());
    std::iota(all.begin(), all.end(), 0u);
    const BinaryTree tree = split(mesh, all, 1);
    std::pair<TriangleSet, TriangleSet> sides = {trianglesOf(tree, tree.nodes.at(0).left),
                                                 trianglesOf(tree, tree.nodes[0].right)};
    if (sides.first.count(0) == 0) std::swap(sides.first, sides.second);
    return sides;
}

}  // namespace clearway::testing
