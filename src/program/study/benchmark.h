// Runs planners on a problem, each so many times, and keeps what OMPL's benchmark logs hold of every run.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "clearway/problem.h"
#include "clearway/scene.h"
#include "program/study/calls.h"

namespace clearway::study {

struct BenchmarkProgress {
    std::string planner;
    int run = 0;      ///< begins, counted from 0 over all planners
    int runs = 0;     ///< of all planners
    double left = 0;  ///< seconds, if the rest takes as long as what is done; before the first run, at most
};

struct BenchmarkOptions {
    double seconds = 30;      ///< for each run's planning
    double megabytes = 4096;  ///< by which the process may grow, from the benchmark's start
    int runs = 10;            ///< of each planner
    std::uint32_t seed = 1;   ///< of the first run of each planner, the second one's is one more, and so on
    bool simplify = true;     ///< paths are simplified and looked at again, after the time is taken
    std::optional<double> step;       ///< as PlanOptions::step
    bool omplWeights = false;         ///< as PlanOptions::omplWeights
    std::function<bool()> isStopped;  ///< asked often; true ends the benchmark, without the run at hand
    std::function<void(const BenchmarkProgress&)> tell;  ///< before each run
};

/// Values by OMPL's names, which end with their type: "time REAL".
using Properties = std::map<std::string, std::string>;

struct BenchmarkRun {
    Properties properties;
    std::vector<Properties> progress;  ///< in the order of time
    bool isSolved = false;
    double length = 0;             ///< of the path, as OMPL's space measures it
    std::vector<PartState> path;   ///< the last one there was: simplified, if it was; empty unless solved
    std::vector<CallBlock> calls;  ///< a sample, if one was asked for
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
    std::string setup;    ///< lines that say what was planned, and with what
    BenchmarkOptions options;
    double seconds = 0;  ///< it took
    std::vector<PlannerBenchmark> planners;
    bool isComplete = false;  ///< not stopped before its end
    std::vector<std::string> warnings;
};

/// The problem's planners, in its order, each with its own parameters and settings; without any, one of each
/// kind: RRTConnect, RRT, EST, KPIECE1 and PRM. Every run has its own space, checker and planner, made from
/// its seed. Throws std::invalid_argument as plan() does, and for what is wrong with any of the planners,
/// before the first run.
Benchmark runBenchmark(const Problem& problem, const Scene& scene, const BenchmarkOptions& options);

}  // namespace clearway::study
