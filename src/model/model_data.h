// The data that copies of a Model share, and their tree for queries.
#pragma once

#include "clearway/model.h"
#include "tree/flat_tree.h"

namespace clearway {

struct Model::Data {
    std::uint64_t id;
    std::uint64_t key;  ///< modelKey of the mesh, options and range
    FlatTree tree;
    BuildReport report;
    std::vector<Component> components;
    MeshOrigin origin;
    std::optional<QueryRange> range;  ///< set only when triangles were left out
};

struct ModelAccess {
    static const FlatTree& tree(const Model& model) { return model.data_->tree; }
};

/// Returns the model's tree, as long as a copy of the model lives.
inline const FlatTree& treeOf(const Model& model) {
    return ModelAccess::tree(model);
}

}  // namespace clearway
