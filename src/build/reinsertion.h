// Improves a tree by moving subtrees to places where they enlarge the nodes above them less.
#pragma once

#include "mesh/clean.h"
#include "tree/binary_tree.h"

namespace clearway {

/// Takes out each subtree, down to those of kLargestMovedWhole triangles or fewer, from the bottom up, and puts it back where the sum of
/// the nodes' areas becomes least. Nodes whose triangles have changed are not rated afterwards. Source: Bittner, Hapala, Havran,
/// Fast Insertion-Based Optimization of Bounding Volume Hierarchies, 2013.
void reinsertSubtrees(BinaryTree& tree, const CleanMesh& mesh);

/// Subtrees of up to this many triangles are moved as wholes. Half of it lets queries visit 1 % less for 10 % more build time.
constexpr std::uint32_t kLargestMovedWhole = 16;

}  // namespace clearway
