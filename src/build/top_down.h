// Builds a binary tree by splitting one node at a time, large subtrees in parallel: the loop that most
// general splits share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "build/triangle_run.h"
#include "tree/binary_tree.h"

namespace clearway {

/// Rearranges the triangles of a node, of which there are at least two, so that its left child's come first,
/// and returns how many those are. 0 or all when it finds no split: the loop then takes halves.
using NodeSplit = std::function<std::size_t(TriangleRun)>;

/// Makes a NodeSplit with scratch of its own, for one task. Called from several threads at once. How a node
/// is split must not depend on the nodes its NodeSplit has seen before.
using MakeNodeSplit = std::function<NodeSplit()>;

/// Below this depth only halves are taken, so that no input makes a deeper tree than this plus the logarithm
/// of its triangles, nor a build slower than quasilinear. Meshes of millions of triangles stay well above it.
constexpr int kDeepestSplit = 96;

/// The topology over the triangles given, volumes not yet fitted. Leaves hold at most largestGroup triangles.
/// The same tree whatever the number of threads.
BinaryTree buildTopDown(const CleanMesh& mesh, std::vector<std::uint32_t> triangles, std::size_t largestGroup,
                        const MakeNodeSplit& makeNodeSplit);

}  // namespace clearway
