// The binary tree that a build makes and flattening reads. Its leaves are runs of triangles.
#pragma once

#include <cstdint>
#include <vector>

#include "tree/rss.h"

namespace clearway {

struct BinaryNode {
    Rss volume;
    std::int32_t left = -1;  ///< index into BinaryTree::nodes; -1 for a leaf
    std::int32_t right = -1;
    std::uint32_t firstTriangle = 0;  ///< into BinaryTree::order, for inner nodes too
    std::uint32_t triangleCount = 0;

    bool isLeaf() const { return left < 0; }
};

struct BinaryTree {
    std::vector<BinaryNode> nodes;     ///< [0] is the root; children come after their parent
    std::vector<std::uint32_t> order;  ///< positions of the triangles in the mesh, leaf after leaf
};

}  // namespace clearway
