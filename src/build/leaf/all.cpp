#include "build/leaf/all.h"

#include <utility>

namespace clearway {

BinaryTree splitIntoSingles(const CleanMesh& mesh, std::vector<std::uint32_t> group, GeneralSplit general) {
    return general(mesh, std::move(group), 1);
}

}  // namespace clearway
