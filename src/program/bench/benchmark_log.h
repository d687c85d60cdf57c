// Writes and reads OMPL's benchmark log of a benchmark's runs, which OMPL's statistics script and Planner Arena read.
#pragma once

#include <iosfwd>
#include <string>

#include "program/bench/benchmark.h"

namespace clearway::study {

/// Writes the log. The format's separators and line ends within values become spaces and commas.
void writeBenchmarkLog(const Benchmark& benchmark, std::ostream& out);

/// Reads a log as strictly as OMPL's script does. Runs have no measures but those in their properties, and no paths. Throws
/// std::runtime_error, which names file, line and what was expected, when the file cannot be read or is no whole log of this
/// version of OMPL.
Benchmark readBenchmarkLog(const std::string& file);

}  // namespace clearway::study
