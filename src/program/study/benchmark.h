// Runs planners on a problem, each several times, and writes OMPL's benchmark log of the runs, which OMPL's
// statistics script and Planner Arena read.
#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "clearway/problem.h"
#include "clearway/scene.h"
#include "program/study/planner_run.h"

namespace clearway::study {

struct BenchmarkProgress {
    std::string planner;
    int run = 0;      ///< the run that begins, counted from 0 over all planners
    int runs = 0;     ///< of all planners
    double left = 0;  ///< estimated seconds, from the runs so far; before the first run, at most
};

struct BenchmarkOptions {
    double seconds = 30;              ///< for each run's planning
    double megabytes = 4096;          ///< growth limit of the process, from the benchmark's start
    int runs = 10;                    ///< of each planner
    std::uint32_t seed = 1;           ///< seed of each planner's first run, incremented per run
    bool simplify = true;             ///< simplifies paths and audits them again, after the time is taken
    std::optional<double> step;       ///< see PlanOptions::step
    bool omplWeights = false;         ///< see PlanOptions::omplWeights
    std::function<bool()> isStopped;  ///< asked often; true ends the benchmark and drops the current run
    std::function<void(const BenchmarkProgress&)> tell;  ///< before each run
};

struct PlannerBenchmark {
    std::string name;                        ///< the planner's, or the label that the problem gives it
    Properties settings;                     ///< parameters of the planner and of the space
    std::vector<std::string> progressNames;  ///< empty when the planner reports no progress
    std::vector<BenchmarkRun> runs;
};

struct Benchmark {
    std::string experiment;  ///< without white space
    Properties parameters;   ///< of the experiment: margin, triangles
    std::string host, cpu;
    std::string started;  ///< date and time
    std::string setup;    ///< lines that describe the problem, the space and the planners
    BenchmarkOptions options;
    double seconds = 0;  ///< the benchmark's duration
    std::vector<PlannerBenchmark> planners;
    bool isComplete = false;  ///< false when the benchmark was stopped before its end
    std::vector<std::string> warnings;
};

/// Runs the problem's planners in the problem's order, each with its own parameters and settings. A problem
/// without planners gets RRTConnect, RRT, EST, KPIECE1 and PRM. Every run has its own space, checker and
/// planner, made from its seed. Throws std::invalid_argument as plan() does, and for a mistake in any of the
/// planners, before the first run.
Benchmark runBenchmark(const Problem& problem, const Scene& scene, const BenchmarkOptions& options);

/// Writes the log. The format's separators and line ends within values become spaces and commas.
void writeBenchmarkLog(const Benchmark& benchmark, std::ostream& out);

}  // namespace clearway::study
