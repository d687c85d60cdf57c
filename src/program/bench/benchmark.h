// Runs planners on a problem, each several times.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <set>
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

/// A run that has ended.
struct EndedRun {
    std::size_t number = 0;  ///< counted from 0 over all planners, in the benchmark's order
    BenchmarkRun run;
    std::vector<std::string> warnings;
};

/// Does the run of this number. Returns nothing when isStopped ended it. Throws as runBenchmark() does.
using DoRun = std::function<std::optional<EndedRun>(std::size_t number)>;

/// All runs of a benchmark, which several processes do.
struct SharedRuns {
    std::size_t count = 0;
    DoRun doRun;                                ///< here
    std::function<void(const EndedRun&)> take;  ///< to be called for each run that has ended
    std::function<void()> keep;                 ///< see BenchmarkOptions::keep
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
    /// Called when runs have ended, with those that have ended so far, and sometimes when none has.
    std::function<void(const Benchmark&)> keep;
    /// Has the runs done by other processes, too.
    std::function<void(const SharedRuns&)> share;
    Properties parameters;  ///< further parameters of the experiment

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
    std::set<std::uint32_t> seeds;  ///< of each planner's runs, whether they have ended or not
    double seconds = 0;             ///< the benchmark's duration
    std::vector<PlannerBenchmark> planners;
    std::vector<std::string> warnings;

    /// False when the benchmark was stopped before its end, or runs were lost.
    bool isComplete() const;
};

/// Runs the problem's planners in the problem's order, each with its own parameters and settings. A problem
/// without planners gets RRTConnect, RRT, EST, KPIECE1 and PRM. Every run has its own space, checker and
/// planner, made from its seed. Throws std::invalid_argument as plan() does, and for a mistake in any of the
/// planners, before the first run.
Benchmark runBenchmark(const Problem& problem, const Scene& scene, const BenchmarkOptions& options);

/// Does runs of this benchmark one by one, for another process's runBenchmark(). The arguments must outlive it.
DoRun runsOf(const Problem& problem, const Scene& scene, const BenchmarkOptions& options);

std::uint32_t seedOf(const BenchmarkRun& run);

/// The seeds of the planner's runs that have not ended.
std::set<std::uint32_t> missingSeeds(const PlannerBenchmark& planner, const Benchmark& benchmark);

/// Adds the run behind those with lesser seeds. Returns false, and adds nothing, when the planner has a run with this seed.
bool addRun(const BenchmarkRun& run, PlannerBenchmark& planner);

}  // namespace clearway::study
