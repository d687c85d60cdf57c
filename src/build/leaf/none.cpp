#include "build/leaf/none.h"

#include <utility>

namespace clearway {

BinaryTree keepTogether(const CleanMesh&, std::vector<std::uint32_t> group, GeneralSplit) {
    BinaryTree tree;
    tree.nodes.emplace_back();
    tree.nodes.front().triangleCount = static_cast<std::uint32_t>(group.size());
    tree.order = std::move(group);
    return tree;
}

}  // namespace clearway
