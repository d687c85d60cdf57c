#include "build/leaf/edge.h"

#include <utility>

#include "build/leaf/grow_chains.h"

namespace clearway {

BinaryTree splitIntoEdgeChains(const CleanMesh& mesh, std::vector<std::uint32_t> group, GeneralSplit) {
    return treeOfChains(growChains(mesh, std::move(group), 2));
}

}  // namespace clearway
