// Writes, reads and joins OMPL's benchmark logs, which OMPL's statistics script and Planner Arena read.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "program/bench/benchmark.h"

namespace clearway::study {

/// Writes the log. The format's separators and line ends within values become spaces and commas.
void writeBenchmarkLog(const Benchmark& benchmark, std::ostream& out);

/// Reads a log as strictly as OMPL's script does. Runs have no measures but those in their properties, and no paths. Throws
/// std::runtime_error, which names file, line and what was expected, when the file cannot be read or is no whole log of this
/// version of OMPL.
Benchmark readBenchmarkLog(const std::string& file);

/// Reads the logs and joins their runs, in the order of their seeds. The result has the seeds that any of the logs announces. Of
/// runs with one seed it has the first. It warns of those left out, and of different processors. Throws as readBenchmarkLog()
/// does, and std::invalid_argument, which names the file, the value and what was expected, when a log has other settings or
/// planners than the first, or runs that it does not announce.
Benchmark mergeLogs(const std::vector<std::string>& files);

}  // namespace clearway::study
