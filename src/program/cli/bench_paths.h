// The paths that the runs of a benchmark found, as files beside its log.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "clearway/problem.h"
#include "program/bench/benchmark.h"

namespace clearway::cli {

/// Writes the paths that the problem asks for, as EXPERIMENT_PLANNER_RUN.path. Returns the number of files; empty when the problem
/// asks for none. Throws std::runtime_error when one cannot be written.
std::optional<std::size_t> writePaths(const study::Benchmark& benchmark, const Problem& problem,
                                      const std::string& log);

}  // namespace clearway::cli
