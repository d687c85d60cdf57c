// Which descendants of a binary node become the lanes of a wide one. A wide node costs its area, as often as
// a query comes to it; of all ways to cut the binary tree into wide nodes, dynamic programming finds the
// cheapest. Source: Ylitie, Karras, Laine, Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide
// BVHs, 2017.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tree/binary_tree.h"
#include "tree/flat_tree.h"

namespace clearway {

class Collapse {
  public:
    static constexpr int kMostLanes = widestOf(NodeWidths());

    /// lanes: of a wide node, 2 to kMostLanes. The tree is not copied.
    Collapse(const BinaryTree& tree, int lanes);

    /// The descendants of an inner node that take its lanes, from left to right: at least two.
    std::vector<std::int32_t> lanesOf(std::int32_t node) const;

    /// Sum over all wide nodes of their area, as a share of the root's, plus 1 / triangles for each.
    double cost() const { return choices_.front().cost[0]; }

  private:
    /// How a subtree is best put into at most i lanes of a wide node above it.
    struct Choice {
        /// [i - 1]: the cost of the wide nodes this takes.
        std::array<float, kMostLanes> cost{};
        /// [i - 1]: the lanes that go to the left child; 0: it is best to take one lane fewer. With one lane
        /// the subtree is a wide node of its own, and [0] is what of its lanes goes left; 0 for a leaf.
        std::array<std::int8_t, kMostLanes> leftLanes{};
    };

    void choose(std::int32_t node);
    void appendLanes(std::int32_t node, int lanes, std::vector<std::int32_t>& result) const;

    const BinaryTree& tree_;
    const int lanes_;
    std::vector<Choice> choices_;  ///< by node
};

}  // namespace clearway
