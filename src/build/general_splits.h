// The table of general splits: how a mesh is divided down to groups small enough for a leaf. A new one is one
// file and one row.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "build/split/axis.h"
#include "build/split/embree.h"
#include "build/split/mean.h"
#include "build/split/sah.h"
#include "mesh/clean.h"
#include "tree/binary_tree.h"

namespace clearway {

/// From triangles (positions in mesh.triangles, at least one) to the topology of a binary tree over them,
/// whose leaves hold at most largestGroup triangles each. Volumes are left unfitted. Splitting one node at a
/// time is the common case: buildTopDown. The same input gives the same tree.
using GeneralSplit = BinaryTree (*)(const CleanMesh& mesh, std::vector<std::uint32_t> triangles,
                                    std::size_t largestGroup);

struct NamedGeneralSplit {
    const char* name;
    GeneralSplit build;
};

constexpr NamedGeneralSplit kGeneralSplits[] = {
    {"sah", buildBySah},
    {"embree", buildByEmbree},
    {"axis", buildByAxisSplit},
    {"mean", buildByMeanSplit},
};

/// Throws std::invalid_argument that lists the known names.
const NamedGeneralSplit& generalSplitNamed(const std::string& name);

}  // namespace clearway
