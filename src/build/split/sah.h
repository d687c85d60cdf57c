// The surface-area heuristic: of many planes, the one whose two sides cost least, a side's cost being the
// area of its box times the leaves its triangles fill. Planes are square to the axes of three frames, between
// bins of centroids. Source: Wald, On fast Construction of SAH-based Bounding Volume Hierarchies, 2007.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/clean.h"
#include "tree/binary_tree.h"

namespace clearway {

/// A general split, as general_splits.h says.
BinaryTree buildBySah(const CleanMesh& mesh, std::vector<std::uint32_t> triangles, std::size_t largestGroup);

}  // namespace clearway
