// From triangles to a tree: a general split down to groups, a leaf split within them, then flattening.
#pragma once

#include "clearway/build_options.h"
#include "mesh/clean.h"
#include "tree/binary_tree.h"
#include "tree/flat_tree.h"

namespace clearway {

/// Any general split with any leaf split; each node's volume fitted to the corners of the triangles below it.
/// options: as requireBuildOptions accepts.
BinaryTree buildBinaryTree(const CleanMesh& mesh, const BuildOptions& options);

/// Wide nodes as Collapse cuts them; width 2 keeps the binary tree.
FlatTree flatten(const BinaryTree& tree, const CleanMesh& mesh, int nodeWidth);

}  // namespace clearway
