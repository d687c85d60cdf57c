// Chains of triangles that hang together by shared vertices: what ChainSplit and EdgeSplit have in common.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/clean.h"
#include "tree/binary_tree.h"

namespace clearway {

struct Chains {
    std::vector<std::uint32_t> triangles;  ///< chain after chain
    std::vector<std::size_t> ends;         ///< of each chain, into triangles
};

/// A chain starts at the first triangle still free and grows by any that shares at least sharedVertices
/// distinct vertices with one already in it (by index: the mesh is welded), until none does.
Chains growChains(const CleanMesh& mesh, std::vector<std::uint32_t> group, int sharedVertices);

/// Topology with one leaf a chain, halving the list of chains from node to node.
BinaryTree treeOfChains(const Chains& chains);

}  // namespace clearway
