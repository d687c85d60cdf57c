// Prints a benchmark: a row for each planner, and which runs are lost.
#pragma once

#include "program/bench/benchmark.h"

namespace clearway::cli {

/// Prints the benchmark's warnings and its rows, and keeps the facts. log: the file that holds it.
void printBenchmark(const study::Benchmark& benchmark, const std::string& log);

}  // namespace clearway::cli
