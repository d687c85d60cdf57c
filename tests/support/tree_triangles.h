// The triangles of a flat tree, one after the other.
#pragma once

#include <vector>

#include "tree/flat_tree.h"

namespace clearway::testing {

/// All triangles, in the order of the leaves' blocks.
inline std::vector<TriangleAt> trianglesOf(const FlatTree& tree) {
    std::vector<TriangleAt> triangles;
    for (const LeafReference at : tree.leaves()) {
        for (std::uint32_t i = 0; i < tree.leaf(at).triangleCount; ++i) triangles.push_back({at, i});
    }
    return triangles;
}

}  // namespace clearway::testing
