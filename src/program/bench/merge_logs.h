// Joins the logs of a job array: of benchmarks that differ in their seeds alone.
#pragma once

#include <string>
#include <vector>

#include "program/bench/benchmark.h"

namespace clearway::study {

/// Reads the logs and joins their runs, in the order of their seeds. The result has the seeds that any of the logs announces. Of
/// runs with one seed it has the first. It warns of those left out, and of different processors. Throws as readBenchmarkLog()
/// does, and std::invalid_argument, which names the file, the value and what was expected, when a log has other settings or
/// planners than the first, or runs that it does not announce.
Benchmark mergeLogs(const std::vector<std::string>& files);

}  // namespace clearway::study
