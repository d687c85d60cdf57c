// The table of leaf splits, which divide a group of triangles that a general split left together. A new leaf
// split is one function in leaf_splits.cpp and one row here.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "build/general_splits.h"

namespace clearway {

/// A leaf split turns a group of 1 to 16 triangles (positions in mesh.triangles) into the topology of a small
/// binary tree over them, of one node when the group stays together. Volumes are not fitted yet. general: the
/// split that made the group.
using LeafSplit = BinaryTree (*)(const CleanMesh& mesh, std::vector<std::uint32_t> group,
                                 GeneralSplit general);

// Source of all four: Ytterlid's thesis, 2013.

/// NoSplit: the group stays together as one leaf.
BinaryTree keepTogether(const CleanMesh& mesh, std::vector<std::uint32_t> group, GeneralSplit general);

/// ChainSplit: the group is divided into chains of triangles that share a vertex.
BinaryTree splitIntoVertexChains(const CleanMesh& mesh, std::vector<std::uint32_t> group,
                                 GeneralSplit general);

/// EdgeSplit: the group is divided into chains of triangles that share an edge.
BinaryTree splitIntoEdgeChains(const CleanMesh& mesh, std::vector<std::uint32_t> group, GeneralSplit general);

/// AllSplit: the general split goes on down to single triangles.
BinaryTree splitIntoSingles(const CleanMesh& mesh, std::vector<std::uint32_t> group, GeneralSplit general);

struct NamedLeafSplit {
    const char* name;
    LeafSplit build;
};

constexpr NamedLeafSplit kLeafSplits[] = {
    {"none", keepTogether},
    {"chain", splitIntoVertexChains},
    {"edge", splitIntoEdgeChains},
    {"all", splitIntoSingles},
};

/// Throws ArgumentError that lists the known names.
const NamedLeafSplit& leafSplitNamed(const std::string& name);

}  // namespace clearway
