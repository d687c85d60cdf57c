// From the binary tree to the flat one that queries read.
#pragma once

#include "build/fit_volumes.h"
#include "mesh/clean.h"
#include "tree/binary_tree.h"
#include "tree/flat_tree.h"

namespace clearway {

/// Makes the flat tree, with the wide nodes that Collapse chooses; width 2 keeps the binary tree. The inner nodes must have been
/// rated. Throws ArgumentError when no tree has nodes of this width.
FlatTree flatten(const BinaryTree& tree, const CleanMesh& mesh, int nodeWidth,
                 FitFrames frames = FitFrames::leastOfSeveral);

}  // namespace clearway
