// OMPL's benchmark log: what its statistics script and Planner Arena read.
#pragma once

#include <iosfwd>

#include "program/study/benchmark.h"

namespace clearway::study {

/// Throws nothing of its own. Values hold neither line ends nor the separators of the format: these become
/// spaces and commas.
void writeBenchmarkLog(const Benchmark& benchmark, std::ostream& out);

}  // namespace clearway::study
