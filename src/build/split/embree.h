// Embree's builder: a binned surface-area heuristic over axis-aligned boxes, for comparison. Source: Wald,
// Woop, Benthin, Johnson, Ernst, Embree: A Kernel Framework for Efficient CPU Ray Tracing, 2014.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/clean.h"
#include "tree/binary_tree.h"

namespace clearway {

/// A general split, as general_splits.h says. It runs on one thread, so that it can be repeated. Embree gives
/// the topology alone. Throws std::runtime_error with Embree's message when it fails.
BinaryTree buildByEmbree(const CleanMesh& mesh, std::vector<std::uint32_t> triangles,
                         std::size_t largestGroup);

}  // namespace clearway
