#include "build/leaf/chain.h"

#include <utility>

#include "build/leaf/grow_chains.h"

namespace clearway {

BinaryTree splitIntoVertexChains(const CleanMesh& mesh, std::vector<std::uint32_t> group, GeneralSplit) {
    return treeOfChains(growChains(mesh, std::move(group), 1));
}

}  // namespace clearway
