// Counts what a flat tree holds.
#pragma once

#include "clearway/build_report.h"
#include "tree/flat_tree.h"

namespace clearway {

/// Node 0, which holds nothing but the root's own volume, counts like any other.
TreeStatistics statistics(const FlatTree& tree);

}  // namespace clearway
