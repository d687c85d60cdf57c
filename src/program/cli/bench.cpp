// clearway bench: runs a problem's planners, each several times, and writes OMPL's benchmark log.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>

#include "clearway/planning/planners.h"
#include "core/replace_file.h"
#include "program/bench/benchmark.h"
#include "program/bench/benchmark_log.h"
#include "program/bench/child_process.h"
#include "program/bench/run_text.h"
#include "program/cli/bench_paths.h"
#include "program/cli/bench_ranks.h"
#include "program/options/facts.h"
#include "program/options/print.h"
#include "program/options/shared_options.h"

namespace clearway::cli {

namespace {

namespace fs = std::filesystem;
using study::Benchmark;
using study::BenchmarkOptions;
using study::BenchmarkRun;
using study::PlannerBenchmark;

/// The values of the options. Fields that replace values of the problem are optional.
struct BenchArguments {
    ProblemChoice problem;
    std::optional<double> seconds, megabytes;
    std::optional<int> runs;
    std::vector<std::string> planners;
    std::optional<SavedPaths> savedPaths;
    bool keepsPathsAsFound = false;
    BenchmarkOptions benchmark;
    TreeChoice trees;
    std::string log;
    std::optional<std::size_t> oneRun;
};

SavedPaths savedPaths(const std::string& which) {
    if (which == "none") return SavedPaths::kNone;
    if (which == "all") return SavedPaths::kAll;
    if (which == "shortest") return SavedPaths::kShortest;
    throw Expected{"none, all or shortest"};
}

bool readArguments(const Arguments& arguments, BenchArguments& given) {
    CommandLine line(
        "clearway bench PROBLEM.cfg [options]",
        "Runs every planner the problem names (without any: RRTConnect, RRT, EST, KPIECE1 and PRM) several\n"
        "times and writes OMPL's benchmark log, for ompl_benchmark_statistics.py and Planner Arena.\n"
        "Ctrl-C leaves a log of the runs that have ended, with exit code 1.\n"
        "Under `mpirun -n N` the runs are handed out to N ranks. A run whose process is killed or fails "
        "is lost,\n"
        "with exit code 1. The same command goes on with what is missing: the runs that ended are in "
        "LOG.runs.\n"
        "For the study of leaf splits see `clearway-study --help`.");
    addProblem(line, given.problem);
    line.option("--log FILE", "the log (PROBLEM.log, in the problem's output folder)", to(given.log));
    line.option("--time S", "seconds for each run, in place of the problem's time_limit (30)",
                positive(given.seconds));
    line.option("--iterations N", "planner iterations in place of --time: repeatable, with the same seeds",
                integer<std::uint64_t>(given.benchmark.iterations, 1, INT64_MAX));
    line.exclude("--time", "--iterations");
    line.option("--memory MB", "memory growth limit in MB, in place of the problem's mem_limit (4096)",
                positive(given.megabytes));
    line.option("--runs N", "runs of each planner, in place of the problem's run_count (10)",
                integer<int>(given.runs, 1, 1000000));
    line.option(
        "--planner NAME",
        "runs only this planner, with the problem's parameters for it if any; may be repeated",
        [&](const std::string& name) { given.planners.push_back(planning::plannerClassName(name)); },
        CommandLine::Count::kRepeatable);
    line.option("--seed N", "seed of each planner's first run, incremented per run (1)",
                integer<std::uint32_t>(given.benchmark.seed, 1, INT32_MAX));
    addOmplWeights(line, given.benchmark.omplWeights);
    line.flag("--no-simplify", "leaves paths as the planners found them", given.keepsPathsAsFound);
    line.option(
        "--save-paths WHICH",
        "paths to write beside the log: none, all or shortest (of each planner), in place of the problem's "
        "save_paths",
        [&](const std::string& which) { given.savedPaths = savedPaths(which); });
    addTarget(line);
    addJson(line);
    addTreeOptions(line, given.trees.options);
    addCache(line, given.trees);
    addOneRun(line, given.oneRun);
    return line.parse(arguments);
}

/// The problem's planners with these names. A name that the problem lacks becomes a planner without
/// parameters.
std::vector<PlannerChoice> choose(const std::vector<std::string>& names,
                                  const std::vector<PlannerChoice>& planners) {
    std::vector<PlannerChoice> chosen;
    for (const std::string& name : names) {
        const std::size_t before = chosen.size();
        for (const PlannerChoice& planner : planners) {
            if (planning::plannerClassName(planner.name) == name) chosen.push_back(planner);
        }
        if (chosen.size() == before) chosen.push_back({name});
    }
    return chosen;
}

/// Reads the problem and replaces its values by those of the options.
Problem readProblemFor(const BenchArguments& given) {
    Problem problem = given.problem.read();
    if (given.seconds) problem.timeLimit = given.seconds;
    if (given.megabytes) problem.memoryLimit = given.megabytes;
    if (given.runs) problem.runCount = given.runs;
    if (!given.planners.empty()) problem.planners = choose(given.planners, problem.planners);
    if (given.savedPaths) problem.savedPaths = *given.savedPaths;
    if (given.keepsPathsAsFound) problem.simplify = false;
    return problem;
}

BenchmarkOptions benchmarkOptions(const BenchArguments& given, const Problem& problem) {
    BenchmarkOptions result = given.benchmark;
    result.seconds = problem.timeLimit.value_or(result.seconds);
    result.megabytes = problem.memoryLimit.value_or(result.megabytes);
    result.runs = problem.runCount.value_or(result.runs);
    result.simplify = problem.simplify;
    result.isStopped = isInterrupted;
    return result;
}

/// The log's file: by default in the problem's output folder, which is made.
std::string logFile(const BenchArguments& given, const Problem& problem) {
    if (!given.log.empty()) return given.log;
    const fs::path folder = fs::path(problem.file).parent_path() / problem.outputFolder;
    if (!problem.outputFolder.empty()) makeFolder(folder.string());
    return (folder / fs::path(problem.file).filename().replace_extension(".log")).string();
}

/// Empty for a lost run.
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

/// Adds the build options to the log, so that one database can tell logs of different trees apart.
void describeTrees(const BuildOptions& tree, Benchmark& benchmark) {
    benchmark.parameters["general_split VARCHAR"] = tree.generalSplit;
    benchmark.parameters["leaf_split VARCHAR"] = tree.leafSplit;
    benchmark.parameters["leaf_size INTEGER"] = std::to_string(tree.leafSize);
}

Benchmark runShown(const Problem& problem, const Scene& scene, BenchmarkOptions options) {
    std::optional<ElapsedLine> line;
    options.tell = [&](const study::BenchmarkProgress& at) {
        line.reset();
        const std::string left =
            std::isfinite(at.left)
                ? ", about " + std::to_string(static_cast<long>(at.left)) + " s left at its start"
                : "";
        line.emplace("run " + std::to_string(at.run + 1) + " of " + std::to_string(at.runs) + ", " +
                     at.planner + left + ", running");
    };
    return study::runBenchmark(problem, scene, options);
}

/// For a process that another one started: does one run and prints it.
int doOneRun(const BenchArguments& given, const Problem& problem) {
    study::endWithParent();
    const BenchmarkOptions options = benchmarkOptions(given, problem);
    const Scene scene = given.trees.load(problem);
    study::ToldRun told;
    const auto run = study::runAlone(problem, scene, options, *given.oneRun, told.warnings);
    if (!run) return kAnswerIsNo;
    told.run = *run;
    return tellRun(textOf(told));
}

void tellLost(const std::vector<LostRun>& lost) {
    for (const LostRun& run : lost) {
        printRow("lost", run.name + ": " + run.end);
        facts()["lost"].push_back({{"run", run.name}, {"end", run.end}});
    }
}

std::string troubleOf(const Benchmark& benchmark, std::size_t lost) {
    if (benchmark.isComplete) return "";
    if (lost > 0) return ", " + counted(lost, "run") + " lost: the same command does what is missing";
    return ", interrupted: the log has the runs that ended";
}

/// ranks: null unless mpirun started this process.
int benchProblem(const Arguments& arguments, study::Ranks* ranks) {
    const auto isStudy = [](const std::string& argument) { return argument.rfind("--study", 0) == 0; };
    if (std::any_of(arguments.begin(), arguments.end(), isStudy))
        throw std::invalid_argument("--study is a program of its own: clearway-study");
    BenchArguments given;
    if (!readArguments(arguments, given)) return kDone;
    const Problem problem = readProblemFor(given);
    if (given.oneRun) return doOneRun(given, problem);
    const std::string log = logFile(given, problem);
    heedInterrupts();  // before files are tried out, so that an interrupt leaves none of them
    OutputFiles files(inputsOf(problem));
    files.add(given.log.empty() ? "the log" : "--log", log);
    requireFactsFile(files);

    BenchmarkOptions options = benchmarkOptions(given, problem);
    const Scene scene = given.trees.load(problem);
    std::optional<BenchmarkOnRanks> onRanks;
    if (ranks) {
        onRanks.emplace(*ranks, arguments, log, inputsOf(problem));
        options.doRuns = [&](Benchmark& benchmark) { return onRanks->doRuns(benchmark); };
    }
    Benchmark benchmark = runShown(problem, scene, options);
    describeTrees(given.trees.options, benchmark);
    replaceFile(log, [&](std::ostream& out) { study::writeBenchmarkLog(benchmark, out); });
    if (onRanks) onRanks->finish(benchmark.isComplete);

    printWarnings(problem.warnings);
    printWarnings(benchmark.warnings);
    printRow("experiment", benchmark.experiment);
    for (const PlannerBenchmark& planner : benchmark.planners) {
        printPlanner(planner);
        facts()["planners"].push_back(factsOf(planner));
    }
    if (onRanks) tellLost(onRanks->lost());
    facts()["experiment"] = benchmark.experiment;
    facts()["seconds"] = toJson(benchmark.seconds);
    facts()["complete"] = benchmark.isComplete;
    facts()["log"] = log;
    if (const auto written = writePaths(benchmark, problem, log))
        printRow("paths", std::to_string(*written) + ", beside the log");
    printRow("took",
             readable(benchmark.seconds) + " s" + troubleOf(benchmark, onRanks ? onRanks->lost().size() : 0));
    printRow("log", log);
    requirePrinted();
    return benchmark.isComplete ? kDone : kAnswerIsNo;
}

}  // namespace

int bench(const Arguments& arguments) {
    return runOnRanks([&](study::Ranks* ranks) { return benchProblem(arguments, ranks); });
}

}  // namespace clearway::cli
