// The table of general splits, which divide a mesh down to groups small enough for a leaf. A new general
// split is one file in split/ and one declaration and row here.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "mesh/clean.h"
#include "tree/binary_tree.h"

namespace clearway {

/// A general split turns triangles (positions in mesh.triangles, at least one) into the topology of a binary
/// tree over them, whose leaves hold at most largestGroup triangles each. Volumes are not fitted yet. Equal
/// input gives equal trees. Most general splits divide one node at a time and use buildTopDown.
using GeneralSplit = BinaryTree (*)(const CleanMesh& mesh, std::vector<std::uint32_t> triangles,
                                    std::size_t largestGroup);

/// The surface-area heuristic: of many planes, the one whose two sides cost least, where a side costs the
/// area of its box times the number of its triangles. Planes lie between bins of centroids, square to the
/// axes of a frame that suits the triangles. Source: Wald, On fast Construction of SAH-based Bounding Volume Hierarchies,
/// 2007.
BinaryTree buildBySah(const CleanMesh& mesh, std::vector<std::uint32_t> triangles, std::size_t largestGroup);

/// Embree's builder, for comparison: a binned surface-area heuristic over axis-aligned boxes. It runs on one
/// thread, so that it can be repeated. Embree only gives the topology. Throws std::runtime_error with
/// Embree's message when Embree fails. Source: Wald, Woop, Benthin, Johnson, Ernst, Embree: A Kernel
/// Framework for Efficient CPU Ray Tracing, 2014.
BinaryTree buildByEmbree(const CleanMesh& mesh, std::vector<std::uint32_t> triangles,
                         std::size_t largestGroup);

/// AxisSplit: divides the triangles by a plane through the mean of their corners, square to the one of three
/// principal axes whose children have the least RSS area. Source: Ytterlid's thesis, 2013.
BinaryTree buildByAxisSplit(const CleanMesh& mesh, std::vector<std::uint32_t> triangles,
                            std::size_t largestGroup);

/// MeanSplit: divides the triangles by the plane through the mean of their corners (which is the mean of
/// their centroids), square to the direction in which the corners spread most. Source: Ytterlid's thesis,
/// 2013, after PQP.
BinaryTree buildByMeanSplit(const CleanMesh& mesh, std::vector<std::uint32_t> triangles,
                            std::size_t largestGroup);

struct NamedGeneralSplit {
    const char* name;
    GeneralSplit build;
    bool isImproved;  ///< by reinsertion; the others stay as their sources describe them
};

constexpr NamedGeneralSplit kGeneralSplits[] = {
    {"sah", buildBySah, true},
#ifndef CLEARWAY_WITHOUT_EMBREE
    {"embree", buildByEmbree, false},
#endif
    {"axis", buildByAxisSplit, false},
    {"mean", buildByMeanSplit, false},
};

/// Throws ArgumentError that lists the known names.
const NamedGeneralSplit& generalSplitNamed(const std::string& name);

}  // namespace clearway
