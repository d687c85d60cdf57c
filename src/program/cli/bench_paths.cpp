#include "program/cli/bench_paths.h"

#include <algorithm>
#include <filesystem>
#include <vector>

namespace clearway::cli {

namespace {

namespace fs = std::filesystem;
using study::Benchmark;
using study::BenchmarkRun;
using study::PlannerBenchmark;

/// Replaces the characters that file names may not have on every system.
std::string fileName(std::string text) {
    for (char& c : text) {
        const bool isPlain = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
                             c == '-' || c == '.';
        if (!isPlain) c = '_';
    }
    return text;
}

/// Writes one planner's paths as EXPERIMENT_PLANNER_RUN.path, with runs counted from 0 as in OMPL.app.
/// Returns the number of files.
std::size_t writePaths(const std::string& stem, const PlannerBenchmark& planner, const Problem& problem) {
    std::optional<std::size_t> shortest;
    std::size_t written = 0;
    for (std::size_t i = 0; i < planner.runs.size(); ++i) {
        const BenchmarkRun& run = planner.runs[i];
        if (!run.isSolved) continue;
        if (!shortest || run.length < planner.runs[*shortest].length) shortest = i;
        if (problem.benchmark.savedPaths != SavedPaths::kAll) continue;
        writePath(run.path, problem.space, stem + "_" + std::to_string(i) + ".path");
        ++written;
    }
    if (problem.benchmark.savedPaths == SavedPaths::kAll || !shortest) return written;
    writePath(planner.runs[*shortest].path, problem.space, stem + "_" + std::to_string(*shortest) + ".path");
    return 1;
}

}  // namespace

std::optional<std::size_t> writePaths(const Benchmark& benchmark, const Problem& problem,
                                      const std::string& log) {
    if (problem.benchmark.savedPaths == SavedPaths::kNone) return std::nullopt;
    std::size_t written = 0;
    std::vector<std::string> names;
    for (const PlannerBenchmark& planner : benchmark.planners) {
        std::string name = fileName(benchmark.experiment + "_" + planner.name);
        const auto before = std::count(names.begin(), names.end(), name);
        names.push_back(name);
        if (before > 0) name += "-" + std::to_string(before + 1);
        written += writePaths((fs::path(log).parent_path() / name).string(), planner, problem);
    }
    return written;
}

}  // namespace clearway::cli
