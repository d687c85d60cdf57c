// The triangles that a model's tree holds.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "clearway/model.h"
#include "model/model_data.h"
#include "tree/flat_tree.h"

namespace clearway {

using TriangleCorners = std::array<Vector3, 3>;

/// Calls take(component, corners) for the triangles, as far as the tree holds them.
template <class Take>
void eachTriangleOf(const Model& model, const Take& take) {
    const std::vector<Component>& components = model.components();
    std::vector<std::size_t> ofTriangle;
    for (std::size_t i = 0; i < components.size(); ++i)
        ofTriangle.resize(components[i].firstTriangle + std::size_t(components[i].triangleCount), i);
    const FlatTree& tree = treeOf(model);
    for (const LeafReference leaf : tree.leaves()) {
        for (std::uint32_t n = 0; n < tree.leaf(leaf).triangleCount; ++n) {
            const TriangleAt at{leaf, n};
            take(ofTriangle.at(tree.triangleId(at)), tree.corners(at));
        }
    }
}

}  // namespace clearway
