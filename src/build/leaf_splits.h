// The table of leaf splits, which divide the groups of triangles that a general split left together. A new leaf split is one
// function and one row here.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "build/general_splits.h"

namespace clearway {

/// A leaf split divides the leaves of a tree, groups of up to 16 triangles, further, or leaves them as they are. general: the split
/// that made the groups.
using LeafSplit = void (*)(BinaryTree& tree, const CleanMesh& mesh, GeneralSplit general);

/// Turns a group of triangles (positions in mesh.triangles) into the topology of a small binary tree over them, of one node when the
/// group stays together.
using GroupSplit = BinaryTree (*)(const CleanMesh& mesh, std::vector<std::uint32_t> group,
                                  GeneralSplit general);

/// Divides one leaf after the other. The new nodes are not rated.
void splitEachGroup(BinaryTree& tree, const CleanMesh& mesh, GeneralSplit general, GroupSplit split);
template <GroupSplit split>
void splitEachGroup(BinaryTree& tree, const CleanMesh& mesh, GeneralSplit general) {
    splitEachGroup(tree, mesh, general, split);
}

// Source of the first four: Ytterlid's thesis, 2013.

/// NoSplit: each group stays together as one leaf.
void keepTogether(BinaryTree& tree, const CleanMesh& mesh, GeneralSplit general);

/// ChainSplit: the group is divided into chains of triangles that share a vertex.
BinaryTree splitIntoVertexChains(const CleanMesh& mesh, std::vector<std::uint32_t> group,
                                 GeneralSplit general);

/// EdgeSplit: the group is divided into chains of triangles that share an edge.
BinaryTree splitIntoEdgeChains(const CleanMesh& mesh, std::vector<std::uint32_t> group, GeneralSplit general);

/// AllSplit: the general split goes on down to single triangles.
BinaryTree splitIntoSingles(const CleanMesh& mesh, std::vector<std::uint32_t> group, GeneralSplit general);

/// CostSplit: each group is divided into the parts whose volumes cost queries least. Groups of more than kMostByCost triangles are
/// first divided by the general split.
void splitByCost(BinaryTree& tree, const CleanMesh& mesh, GeneralSplit general);

/// Up to this many triangles, all ways to divide a group are compared.
constexpr std::size_t kMostByCost = 4;
BinaryTree splitIntoSmallGroups(const CleanMesh& mesh, std::vector<std::uint32_t> group,
                                GeneralSplit general);

struct NamedLeafSplit {
    const char* name;
    LeafSplit build;
};

constexpr NamedLeafSplit kLeafSplits[] = {
    {"none", keepTogether},
    {"chain", splitEachGroup<splitIntoVertexChains>},
    {"edge", splitEachGroup<splitIntoEdgeChains>},
    {"all", splitEachGroup<splitIntoSingles>},
    {"cost", splitByCost},
};

/// Throws ArgumentError that lists the known names.
const NamedLeafSplit& leafSplitNamed(const std::string& name);

}  // namespace clearway
