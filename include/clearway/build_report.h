// The report of a build: what cleaning found, and the shape of the tree.
#pragma once

#include <cstddef>
#include <vector>

#include "clearway/build_options.h"

#pragma GCC visibility push(default)

namespace clearway {

/// What cleaning found. Cleaning removes no part of the surface, only repetitions of it.
struct CleanReport {
    std::size_t weldedVertices = 0;       ///< vertices exactly equal to an earlier one
    std::size_t unusedVertices = 0;       ///< vertices that no triangle uses
    std::size_t degenerateTriangles = 0;  ///< zero area; kept as the segment or point they are
    std::size_t duplicateTriangles = 0;   ///< three vertices of an earlier triangle, in any order; dropped
};

/// The shape of a tree.
struct TreeStatistics {
    std::size_t nodes = 0;                  ///< wide nodes
    std::size_t leaves = 0;                 ///< groups of triangles at the ends of the tree
    std::vector<std::size_t> leavesBySize;  ///< [k] = leaves that hold k triangles; [0] unused
    int depth = 0;                          ///< wide nodes on the longest path from the root to a leaf
    double meanChildren = 0;                ///< used lanes per node
    std::size_t bytes = 0;                  ///< all memory of the tree, including exact vertices and ids
};

/// How a model was built, and what came out of it.
struct BuildReport {
    BuildOptions options;                  ///< as given
    CleanReport clean;                     ///< about the mesh as given
    TreeStatistics tree;                   ///< about the tree that queries use
    std::size_t triangles = 0;             ///< in the tree, without duplicates and unreachable ones
    std::size_t unreachableTriangles = 0;  ///< left out because no pose within the reach comes near them
    double seconds = 0;                    ///< cleaning, fitting, splitting and flattening
};

}  // namespace clearway

#pragma GCC visibility pop
