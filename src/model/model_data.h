// What a Model shares between its copies.
#pragma once

#include "clearway/model.h"
#include "tree/flat_tree.h"

namespace clearway {

struct Model::Data {
    std::uint64_t id;
    std::uint64_t key;  ///< modelKey of what it was built from
    FlatTree tree;
    BuildReport report;
    std::vector<Component> components;
    MeshOrigin origin;
    std::optional<Reach> reach;  ///< set when triangles were left out
};

}  // namespace clearway
