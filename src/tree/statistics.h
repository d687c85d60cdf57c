// Counts what a flat tree holds.
#pragma once

#include "clearway/build_report.h"
#include "tree/flat_tree.h"

namespace clearway {

TreeStatistics statistics(const FlatTree& tree);

}  // namespace clearway
