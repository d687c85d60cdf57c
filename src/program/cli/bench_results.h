// The results of a benchmark: a row for each planner and for lost runs, and paths as files beside its log.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "clearway/problem.h"
#include "program/bench/benchmark.h"

namespace clearway::cli {

/// Prints the benchmark's warnings and its rows, and keeps the facts. log: the file that holds it.
void printBenchmark(const study::Benchmark& benchmark, const std::string& log);

/// Writes the paths that the problem asks for, as EXPERIMENT_PLANNER_RUN.path. Returns the number of files; empty when the problem
/// asks for none. Throws std::runtime_error when one cannot be written.
std::optional<std::size_t> writePaths(const study::Benchmark& benchmark, const Problem& problem,
                                      const std::string& log);

}  // namespace clearway::cli
