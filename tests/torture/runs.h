// The run itself: family after family, round after round, until there is enough.
#pragma once

#include <vector>

#include "torture/figures.h"
#include "torture/torture_options.h"

namespace clearway::testing {

/// Tells the progress on standard error, and on standard output the first violation of each family with its
/// smallest repeat.
std::vector<PairFigures> runPairs(const TortureOptions& options);
std::vector<MeshFigures> runMeshes(const TortureOptions& options);

}  // namespace clearway::testing
