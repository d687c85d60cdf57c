// The binary tree that a build divides the triangles into, before wide nodes are made of it. Its leaves are runs of triangles.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/large_vector.h"

namespace clearway {

/// Three orthonormal axes, one after the other.
using FrameAxes = std::array<float, 9>;

constexpr FrameAxes kModelAxes = {1, 0, 0, 0, 1, 0, 0, 0, 1};

/// The area of nodes that were not rated yet, and of leaves.
constexpr float kNotRated = -1;

struct BinaryNode {
    std::int32_t left = -1;  ///< index into BinaryTree::nodes; -1 for a leaf
    std::int32_t right = -1;
    std::uint32_t firstTriangle = 0;  ///< into BinaryTree::order, for inner nodes too
    std::uint32_t triangleCount = 0;
    float area =
        kNotRated;  ///< of a volume around (a sample of) the triangles, in a unit that all nodes share
    FrameAxes axes = kModelAxes;  ///< the frame of that volume; its parent's if the node was not rated

    /// The cost of the node as a leaf, in the unit of the areas. A leaf split that weighs costs sets it, also for inner nodes that the
    /// collapse may make leaves; 0 for all others.
    float costAsLeaf = 0;

    bool isLeaf() const { return left < 0; }
};

struct BinaryTree {
    LargeVector<BinaryNode> nodes;     ///< [0] is the root; children come after their parent
    std::vector<std::uint32_t> order;  ///< positions of the triangles in the mesh, leaf after leaf
};

}  // namespace clearway
