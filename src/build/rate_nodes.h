// The areas by which inner nodes are collapsed, for splits that did not find them on their way.
#pragma once

#include "mesh/clean.h"
#include "tree/binary_tree.h"

namespace clearway {

/// Finds the area and the frame of each inner node that has none: the least area of a volume around a sample of its triangles, over
/// the frames of their area, of their corners, of the model and of the node above.
void rateNodes(BinaryTree& tree, const CleanMesh& mesh);

}  // namespace clearway
