// From triangles to a binary tree: a general split down to groups, a leaf split within them, then volumes.
#pragma once

#include "clearway/build_options.h"
#include "mesh/clean.h"
#include "tree/binary_tree.h"

namespace clearway {

/// Builds the tree with the options' splits and fits each node's volume to the corners of the triangles below
/// it. Throws ArgumentError as requireBuildOptions does.
BinaryTree buildBinaryTree(const CleanMesh& mesh, const BuildOptions& options);

}  // namespace clearway
