// AllSplit: the general split goes on down to single triangles. Source: Ytterlid's thesis, 2013.
#pragma once

#include <cstdint>
#include <vector>

#include "build/general_splits.h"

namespace clearway {

/// A leaf split, as leaf_splits.h says.
BinaryTree splitIntoSingles(const CleanMesh& mesh, std::vector<std::uint32_t> group, GeneralSplit general);

}  // namespace clearway
