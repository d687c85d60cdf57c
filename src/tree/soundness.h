// Whether a tree that came from outside can be searched without leaving its arrays.
#pragma once

#include <cstddef>

#include "tree/flat_tree.h"

namespace clearway {

/// Null when every reference of the tree stays within it and no search can run in a circle, otherwise what is
/// wrong. meshTriangles: triangle ids are below it.
const char* faultOf(const FlatTree& tree, std::size_t meshTriangles);

}  // namespace clearway
