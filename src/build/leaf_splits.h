// The table of leaf splits: what becomes of a group of triangles that a general split left together. A new
// one is one file and one row.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "build/general_splits.h"
#include "build/leaf/all.h"
#include "build/leaf/chain.h"
#include "build/leaf/edge.h"
#include "build/leaf/none.h"

namespace clearway {

/// From a group of 1 to 16 triangles (positions in mesh.triangles) to the topology of a small binary tree
/// over them, of one node when the group stays together. Volumes are left unfitted. general is the split that
/// made the group.
using LeafSplit = BinaryTree (*)(const CleanMesh& mesh, std::vector<std::uint32_t> group,
                                 GeneralSplit general);

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

/// Throws std::invalid_argument that lists the known names.
const NamedLeafSplit& leafSplitNamed(const std::string& name);

}  // namespace clearway
