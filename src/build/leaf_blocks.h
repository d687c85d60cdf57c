// The leaves of a flat tree: one block of memory each.
#pragma once

#include <cstdint>
#include <vector>

#include "build/leaf_order.h"
#include "mesh/clean.h"
#include "tree/binary_tree.h"
#include "tree/flat_tree.h"

namespace clearway {

/// Covers the rounding of a distance between two points in double, relative to it.
constexpr double kLengthRounding = 1 + 8 * 0x1p-53;

/// Whether the largest of some squared distances is such that squares can neither have vanished nor overflowed.
constexpr bool areSquaresSafe(double largestSquared) {
    return largestSquared > 0x1p-900 && largestSquared < 0x1p900;
}

/// Where a leaf of the binary tree hangs in the flat one.
struct LeafPlace {
    std::int32_t binaryNode;
    std::uint32_t wideNode;
    int lane;
};

/// Fills in the tree's leafBlocks and vertices, in the order of the leaves, and returns the leaves' references. Throws
/// ArgumentError when the blocks are too many for references.
std::vector<LeafReference> addLeafBlocks(const std::vector<LeafPlace>& leaves, const BinaryTree& binary,
                                         const LeafOrder& order, const CleanMesh& mesh, FlatTree& tree);

}  // namespace clearway
