// Runs planners on a problem, each several times.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "clearway/problem.h"
#include "clearway/scene.h"
#include "program/bench/planner_run.h"

namespace clearway::study {

struct BenchmarkProgress {
    std::string planner;
    int run = 0;      ///< the run that begins, counted from 0 over all planners
    int runs = 0;     ///< of all planners
    double left = 0;  ///< estimated seconds, from the runs so far; before the first run, at most
};

struct Benchmark;

struct BenchmarkOptions {
    double seconds = 30;  ///< for each run's planning, unless iterations limit it
    /// The repeatable limit of each run's planning: how often the planner may ask whether to end.
    std::optional<std::uint64_t> iterations;
    double megabytes = 4096;          ///< growth limit of the process, from the benchmark's start
    int runs = 10;                    ///< of each planner
    std::uint32_t seed = 1;           ///< seed of each planner's first run, incremented per run
    bool simplify = true;             ///< simplifies paths and audits them again, after the time is taken
    bool omplWeights = false;         ///< see PlanOptions::omplWeights
    std::function<bool()> isStopped;  ///< asked often; true ends the benchmark and drops the current run
    std::function<void(const BenchmarkProgress&)> tell;  ///< before each run
    /// Takes the place of doing the runs here: fills in the planners' runs. Returns whether it has all of them.
    std::function<bool(Benchmark&)> doRuns;

    /// Infinite where iterations are the limit.
    double secondsLimit() const { return iterations ? std::numeric_limits<double>::infinity() : seconds; }
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
    bool isComplete = false;  ///< false when the benchmark was stopped before its end, or runs were lost
    std::vector<std::string> warnings;
};

/// Runs the problem's planners in the problem's order, each with its own parameters and settings. A problem
/// without planners gets RRTConnect, RRT, EST, KPIECE1 and PRM. Every run has its own space, checker and
/// planner, made from its seed. Throws std::invalid_argument as plan() does, and for a mistake in any of the
/// planners, before the first run.
Benchmark runBenchmark(const Problem& problem, const Scene& scene, const BenchmarkOptions& options);

/// A benchmark's run, counted from 0 over all planners, in the benchmark's order.
struct RunPlace {
    std::size_t planner = 0;
    int run = 0;  ///< of this planner
};
RunPlace placeOf(std::size_t run, const BenchmarkOptions& options);

/// The seed of a planner's run.
std::uint32_t seedOf(int run, const BenchmarkOptions& options);

/// Does one run alone. Returns nothing when isStopped ended it. Throws as runBenchmark() does, and std::invalid_argument when
/// the benchmark has no such run.
std::optional<BenchmarkRun> runAlone(const Problem& problem, const Scene& scene,
                                     const BenchmarkOptions& options, std::size_t run,
                                     std::vector<std::string>& warnings);

/// The log's entry for a run whose process crashed or was killed: its seed, and OMPL's status for that.
BenchmarkRun lostRun(std::uint32_t seed);

}  // namespace clearway::study
