// MeanSplit: halves the triangles by the plane through the mean of their corners (which is the mean of their
// centroids), square to the direction in which the corners spread most. Source: Ytterlid's thesis, 2013,
// after PQP.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/clean.h"
#include "tree/binary_tree.h"

namespace clearway {

/// A general split, as general_splits.h says.
BinaryTree buildByMeanSplit(const CleanMesh& mesh, std::vector<std::uint32_t> triangles,
                            std::size_t largestGroup);

}  // namespace clearway
