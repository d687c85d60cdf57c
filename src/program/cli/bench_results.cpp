#include "program/cli/bench_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "core/text.h"
#include "program/options/facts.h"
#include "program/options/print.h"

namespace clearway::cli {

namespace {

using study::Benchmark;
using study::BenchmarkRun;
using study::PlannerBenchmark;
using Seeds = std::set<std::uint32_t>;

/// Empty for a run without a time.
std::optional<double> secondsOf(const BenchmarkRun& run) {
    const auto found = run.properties.find("time REAL");
    if (found == run.properties.end()) return std::nullopt;
    return std::stod(found->second);
}

void tellPlanner(const PlannerBenchmark& planner) {
    std::vector<double> seconds, lengths;
    Json runs = Json::array();
    for (const BenchmarkRun& run : planner.runs) {
        const std::optional<double> took = secondsOf(run);
        if (took) seconds.push_back(*took);
        if (run.isSolved) lengths.push_back(run.length);
        runs.push_back({{"solved", run.isSolved},
                        {"seconds", took ? toJson(*took) : Json()},
                        {"length", run.isSolved ? toJson(run.length) : Json()}});
    }
    facts()["planners"].push_back({{"name", planner.name}, {"runs", runs}});
    const auto median = [](std::vector<double>& values) {
        std::nth_element(values.begin(), values.begin() + static_cast<long>(values.size() / 2), values.end());
        return values[values.size() / 2];
    };
    std::string text = fmt::format("{} of {} solved", lengths.size(), counted(planner.runs.size(), "run"));
    if (!seconds.empty()) text += ", " + readable(median(seconds)) + " s";
    if (!lengths.empty()) text += ", length " + shownLength(median(lengths));
    printRow(planner.name, text + (seconds.empty() ? "" : " in the median"));
}

/// "seed 3", "seeds 1 to 4, 7".
std::string shownSeeds(const Seeds& seeds) {
    std::vector<std::string> ranges;
    for (auto first = seeds.begin(); first != seeds.end();) {
        auto last = first, next = std::next(first);
        for (; next != seeds.end() && *next == *last + 1; ++next) last = next;
        ranges.push_back(first == last ? fmt::format("{}", *first) : fmt::format("{} to {}", *first, *last));
        first = next;
    }
    return (seeds.size() == 1 ? "seed " : "seeds ") + joined(ranges);
}

/// Returns how many runs are lost.
std::size_t tellLost(const Benchmark& benchmark) {
    std::size_t lost = 0;
    for (const PlannerBenchmark& planner : benchmark.planners) {
        const Seeds seeds = missingSeeds(planner, benchmark);
        if (seeds.empty()) continue;
        lost += seeds.size();
        printRow("lost", planner.name + ", " + shownSeeds(seeds));
        facts()["lost"].push_back({{"planner", planner.name}, {"seeds", seeds}});
    }
    return lost;
}

namespace fs = std::filesystem;

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

void printBenchmark(const Benchmark& benchmark, const std::string& log) {
    printWarnings(benchmark.warnings);
    printRow("experiment", benchmark.experiment);
    for (const PlannerBenchmark& planner : benchmark.planners) tellPlanner(planner);
    const std::size_t lost = tellLost(benchmark);
    std::string trouble;
    if (lost > 0) trouble = ", " + counted(lost, "run") + " lost";
    if (lost > 0 && isInterrupted()) trouble = ", interrupted: the log has the runs that ended";
    tell({kept("experiment", benchmark.experiment),
          {"took", readable(benchmark.seconds) + " s" + trouble, "seconds", toJson(benchmark.seconds)},
          kept("complete", lost == 0),
          {"log", log, "log", log}});
}

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
