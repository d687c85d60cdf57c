// AxisSplit: halves the triangles at their mean along the one of three principal axes whose children have the
// least RSS area. Source: Ytterlid's thesis, 2013.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/clean.h"
#include "tree/binary_tree.h"

namespace clearway {

/// A general split, as general_splits.h says. Mean and axes are those of the triangles' corners.
BinaryTree buildByAxisSplit(const CleanMesh& mesh, std::vector<std::uint32_t> triangles,
                            std::size_t largestGroup);

}  // namespace clearway
