#include "program/cli/print_benchmark.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

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

Json factsOf(const PlannerBenchmark& planner) {
    Json runs = Json::array();
    for (const BenchmarkRun& run : planner.runs)
        runs.push_back({{"solved", run.isSolved},
                        {"seconds", secondsOf(run) ? toJson(*secondsOf(run)) : Json()},
                        {"length", run.isSolved ? toJson(run.length) : Json()}});
    return {{"name", planner.name}, {"runs", runs}};
}

void printPlanner(const PlannerBenchmark& planner) {
    std::vector<double> seconds, lengths;
    for (const BenchmarkRun& run : planner.runs) {
        if (const auto ofRun = secondsOf(run)) seconds.push_back(*ofRun);
        if (run.isSolved) lengths.push_back(run.length);
    }
    const auto median = [](std::vector<double>& values) {
        std::nth_element(values.begin(), values.begin() + static_cast<long>(values.size() / 2), values.end());
        return values[values.size() / 2];
    };
    std::string text =
        std::to_string(lengths.size()) + " of " + counted(planner.runs.size(), "run") + " solved";
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
        ranges.push_back(std::to_string(*first) + (first == last ? "" : " to " + std::to_string(*last)));
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

}  // namespace

void printBenchmark(const Benchmark& benchmark, const std::string& log) {
    printWarnings(benchmark.warnings);
    printRow("experiment", benchmark.experiment);
    for (const PlannerBenchmark& planner : benchmark.planners) {
        printPlanner(planner);
        facts()["planners"].push_back(factsOf(planner));
    }
    const std::size_t lost = tellLost(benchmark);
    facts()["experiment"] = benchmark.experiment;
    facts()["seconds"] = toJson(benchmark.seconds);
    facts()["complete"] = lost == 0;
    facts()["log"] = log;
    std::string trouble;
    if (lost > 0) trouble = ", " + counted(lost, "run") + " lost";
    if (lost > 0 && isInterrupted()) trouble = ", interrupted: the log has the runs that ended";
    printRow("took", readable(benchmark.seconds) + " s" + trouble);
    printRow("log", log);
}

}  // namespace clearway::cli
