// Chooses which descendants of a binary node become the lanes of a wide node.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tree/binary_tree.h"
#include "tree/flat_tree.h"

namespace clearway {

/// Chooses which descendants of a binary node become the lanes of a wide node. A wide node costs its area,
/// which stands for how often a query visits it; of all ways to cut the binary tree into wide nodes, dynamic
/// programming finds the cheapest. Source: Ylitie, Karras, Laine, Efficient Incoherent Ray Traversal on GPUs
/// Through Compressed Wide BVHs, 2017.
class Collapse {
  public:
    static constexpr int kMostLanes = widestOf(NodeWidths());

    /// lanes: of a wide node, 2 to kMostLanes. The tree is not copied.
    Collapse(const BinaryTree& tree, int lanes);

    using Lanes = std::array<std::int32_t, kMostLanes>;

    /// The descendants of an inner node that become its lanes, from left to right. Returns their number, at least two.
    int lanesOf(std::int32_t node, Lanes& lanes) const;

    /// Whether the node becomes a leaf: because it is one, or because that costs less than its children.
    bool isLeaf(std::int32_t node) const { return choices_[node].leftLanes[0] == 0; }

    /// The sum over all wide nodes of their area, as a share of the root's, plus 1 / triangles for each; and over all leaves of their costs.
    double cost() const { return choices_.front().cost[0]; }

  private:
    /// The best way to put a subtree into at most i lanes of a wide node above it.
    struct Choice {
        /// Entry [i - 1]: the cost of the wide nodes this takes.
        std::array<float, kMostLanes> cost{};
        /// Entry [i - 1]: the number of lanes that go to the left child; 0 if one lane fewer is best. Entry
        /// [0]: if this subtree becomes its own wide node, how many of that node's lanes its left child takes
        /// (0 for a leaf).
        std::array<std::int8_t, kMostLanes> leftLanes{};
    };

    void choose(std::int32_t node);
    void appendLanes(std::int32_t node, int most, Lanes& lanes, int& count) const;

    const BinaryTree& tree_;
    const int lanes_;
    LargeVector<Choice> choices_;  ///< by node
};

}  // namespace clearway
