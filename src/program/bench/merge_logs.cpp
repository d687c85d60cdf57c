// Joins the logs of a job array: of benchmarks that differ in their seeds alone.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "core/number.h"
#include "core/text.h"
#include "program/bench/benchmark_log.h"

namespace clearway::study {
namespace {

/// The lines of a log that seeds, machines and runs do not change.
std::vector<std::string> settingsOf(const Benchmark& log) {
    std::vector<std::string> all = {"Experiment " + log.experiment,
                                    shortNumber(log.options.seconds) + " seconds per run",
                                    shortNumber(log.options.megabytes) + " MB per run"};
    const auto add = [&](const std::string& of, const Properties& values) {
        for (const auto& [name, value] : values) all.push_back(of + name + " = " + value);
    };
    add("", log.parameters);
    all.push_back("planners " + joined(clearway::namesOf(log.planners)));
    for (const PlannerBenchmark& planner : log.planners) {
        add(planner.name + ": ", planner.settings);
        all.push_back(planner.name + ": progress of " + joined(planner.progressNames));
    }
    std::istringstream setup(log.setup);
    for (std::string line; std::getline(setup, line);) all.push_back(line);
    return all;
}

void requireSame(const Benchmark& first, const Benchmark& log, const std::string& file,
                 const std::string& firstFile) {
    const std::vector<std::string> expected = settingsOf(first), found = settingsOf(log);
    const auto [wanted, other] = std::mismatch(expected.begin(), expected.end(), found.begin(), found.end());
    if (wanted == expected.end() && other == found.end()) return;
    const auto shown = [](auto line, const auto& lines) {
        return line == lines.end() ? "nothing more" : quote(*line);
    };
    throw std::invalid_argument(file + " has " + shown(other, found) + ", expected " +
                                shown(wanted, expected) + " as in " + firstFile);
}

/// The line by which logs name the processor's model.
std::string modelOf(const Benchmark& log) {
    const std::size_t begin = log.cpu.find("Model name:");
    return begin == std::string::npos ? "" : log.cpu.substr(begin, log.cpu.find('\n', begin) - begin);
}

constexpr std::uint32_t kMostRuns = 1000000;

void requireSeed(const BenchmarkRun& run, const std::string& file, const std::string& planner) {
    const auto found = run.properties.find("seed INTEGER");
    const auto seed = found == run.properties.end() ? std::nullopt : parseNumber(found->second);
    if (seed && *seed >= 0 && *seed <= std::numeric_limits<std::uint32_t>::max() &&
        *seed == std::floor(*seed))
        return;
    throw std::invalid_argument(fmt::format(
        "{} has a run of {} with seed '{}', expected a log of clearway bench, with a whole number", file,
        planner, found == run.properties.end() ? "" : found->second));
}

/// Seeds from the first to the last; those that no log has are lost.
std::set<std::uint32_t> withoutGaps(const std::set<std::uint32_t>& seeds) {
    std::set<std::uint32_t> all;
    if (seeds.empty()) return all;
    if (*seeds.rbegin() - *seeds.begin() >= kMostRuns) {
        throw std::invalid_argument(fmt::format(
            "the logs have runs with seeds from {} to {}, expected at most {} seeds from the first to the "
            "last",
            *seeds.begin(), *seeds.rbegin(), kMostRuns));
    }
    for (std::uint32_t seed = *seeds.begin(); all.size() <= *seeds.rbegin() - *seeds.begin(); ++seed)
        all.insert(seed);
    return all;
}

/// Refuses runs with other seeds than the log's header announces.
void addRuns(const Benchmark& log, const std::string& file, Benchmark& all) {
    if (log.options.runs > static_cast<int>(kMostRuns)) {
        throw std::invalid_argument(fmt::format("{} announces {} runs per planner, expected at most {}", file,
                                                log.options.runs, kMostRuns));
    }
    std::set<std::uint32_t> seeds;
    for (int run = 0; run < log.options.runs; ++run)
        seeds.insert(log.options.seed + static_cast<std::uint32_t>(run));
    std::size_t leftOut = 0;
    for (std::size_t i = 0; i < log.planners.size(); ++i) {
        for (const BenchmarkRun& run : log.planners[i].runs) {
            requireSeed(run, file, log.planners[i].name);
            if (seeds.count(seedOf(run)) == 0)
                throw std::invalid_argument(fmt::format("{} has a run of {} with seed {}, expected {} to {}",
                                                        file, log.planners[i].name, seedOf(run),
                                                        *seeds.begin(), *seeds.rbegin()));
            leftOut += !addRun(run, all.planners[i]);
        }
    }
    if (leftOut > 0)
        all.warnings.push_back(
            fmt::format("{}: {} left out, because logs before it have runs with the same seeds", file,
                        leftOut == 1 ? "1 run is" : fmt::format("{} runs are", leftOut)));
    all.seeds.merge(seeds);
}

}  // namespace

Benchmark mergeLogs(const std::vector<std::string>& files) {
    Benchmark all;
    std::vector<std::string> hosts;
    for (const std::string& file : files) {
        const Benchmark log = readBenchmarkLog(file);
        if (&file == &files.front()) {
            all = log;
            all.seconds = 0;
            for (PlannerBenchmark& planner : all.planners) planner.runs.clear();
        }
        requireSame(all, log, file, files.front());
        addRuns(log, file, all);
        all.seconds += log.seconds;
        if (std::find(hosts.begin(), hosts.end(), log.host) == hosts.end()) hosts.push_back(log.host);
        if (modelOf(log) != modelOf(all))
            all.warnings.push_back(file + ": times are from another processor than in " + files.front());
    }
    all.host = joined(hosts, "+");
    all.seeds = withoutGaps(all.seeds);
    if (all.seeds.empty()) return all;
    all.options.seed = *all.seeds.begin();
    all.options.runs = static_cast<int>(all.seeds.size());
    return all;
}

}  // namespace clearway::study
