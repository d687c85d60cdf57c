// Gives every node of a tree its volume.
#pragma once

#include "build/fits.h"
#include "mesh/clean.h"
#include "tree/binary_tree.h"

namespace clearway {

/// Fits every node to the vertices of the triangles below it, parents before their children, subtrees in
/// parallel. The same tree whatever the number of threads.
void fitVolumes(BinaryTree& tree, const LeafOrder& mesh, Fit fit);

}  // namespace clearway
