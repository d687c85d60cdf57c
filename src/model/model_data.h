// The data that copies of a Model share.
#pragma once

#include "clearway/model.h"
#include "tree/flat_tree.h"

namespace clearway {

struct Model::Data {
    std::uint64_t id;
    std::uint64_t key;  ///< modelKey of the mesh, options and reach
    FlatTree tree;
    BuildReport report;
    std::vector<Component> components;
    MeshOrigin origin;
    std::optional<Reach> reach;  ///< set only when triangles were left out
};

}  // namespace clearway
