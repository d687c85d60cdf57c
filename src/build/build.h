// From triangles to a tree: a general split down to groups, a leaf split within them, then wide nodes and their volumes.
#pragma once

#include "clearway/build_options.h"
#include "mesh/clean.h"
#include "tree/binary_tree.h"
#include "tree/flat_tree.h"

namespace clearway {

/// Divides the triangles with the options' splits and rates the inner nodes. Throws ArgumentError as requireBuildOptions
/// does.
BinaryTree buildBinaryTree(const CleanMesh& mesh, const BuildOptions& options);

/// Builds the tree that queries read: the binary tree, flattened. Throws ArgumentError as requireBuildOptions does.
FlatTree buildTree(const CleanMesh& mesh, const BuildOptions& options);

}  // namespace clearway
