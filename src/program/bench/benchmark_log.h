// Writes OMPL's benchmark log of a benchmark's runs, which OMPL's statistics script and Planner Arena read.
#pragma once

#include <iosfwd>

#include "program/bench/benchmark.h"

namespace clearway::study {

/// Writes the log. The format's separators and line ends within values become spaces and commas.
void writeBenchmarkLog(const Benchmark& benchmark, std::ostream& out);

}  // namespace clearway::study
