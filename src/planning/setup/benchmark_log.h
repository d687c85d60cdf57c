// OMPL's benchmark log: what its statistics script and Planner Arena read.
#pragma once

#include <iosfwd>

#include "planning/setup/benchmark.h"

namespace clearway::planning {

/// Throws nothing of its own. Values hold neither line ends nor the separators of the format: these become
/// spaces and commas.
void writeBenchmarkLog(const Benchmark& benchmark, std::ostream& out);

}  // namespace clearway::planning
