// clearway bench: runs a problem's planners, each several times, and writes OMPL's benchmark log.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>

#include "clearway/planning/planners.h"
#include "core/clock.h"
#include "core/hash.h"
#include "core/replace_file.h"
#include "program/bench/benchmark.h"
#include "program/bench/benchmark_log.h"
#include "program/bench/run_text.h"
#include "program/cli/bench_results.h"
#include "program/cli/run_on_ranks.h"
#include "program/options/facts.h"
#include "program/options/print.h"
#include "program/options/shared_options.h"

namespace clearway::cli {

namespace {

namespace fs = std::filesystem;
using study::Benchmark;
using study::BenchmarkOptions;

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
        "Under `mpirun -n N` or `srun -n N` each of N ranks does its share of the runs, and rank 0 writes "
        "the log.\n"
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
    bool merges = false;  // this option is mergeBench()'s
    line.flag(
        "--merge",
        "`clearway bench --merge LOG... --log FILE` joins logs that differ in their seeds alone, and names "
        "missing runs as lost",
        merges);
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
    if (given.seconds) problem.benchmark.timeLimit = given.seconds;
    if (given.megabytes) problem.benchmark.memoryLimit = given.megabytes;
    if (given.runs) problem.benchmark.runCount = given.runs;
    if (!given.planners.empty())
        problem.planning.planners = choose(given.planners, problem.planning.planners);
    if (given.savedPaths) problem.benchmark.savedPaths = *given.savedPaths;
    if (given.keepsPathsAsFound) problem.benchmark.simplify = false;
    return problem;
}

/// Options and files that one database, and --merge, must tell apart.
study::Properties parametersOf(const BenchArguments& given, const Problem& problem) {
    const BuildOptions& tree = given.trees.options;
    study::Properties parameters = {{"general_split VARCHAR", tree.generalSplit},
                                    {"leaf_split VARCHAR", tree.leafSplit},
                                    {"leaf_size INTEGER", std::to_string(tree.leafSize)},
                                    {"simplify BOOLEAN", problem.benchmark.simplify ? "1" : "0"}};
    Hash hash;
    for (const std::string& file : inputsOf(problem)) {
        std::ifstream in(file, std::ios::binary);
        hash.add(std::string(std::istreambuf_iterator<char>(in), {}));
    }
    // Planner Arena takes a text that looks like a decimal number for one, and then cannot compare it with the column's texts.
    parameters["hash_of_files VARCHAR"] = fmt::format("{:#x}", hash.value());
    return parameters;
}

BenchmarkOptions benchmarkOptions(const BenchArguments& given, const Problem& problem) {
    BenchmarkOptions result = given.benchmark;
    result.seconds = problem.benchmark.timeLimit.value_or(result.seconds);
    result.megabytes = problem.benchmark.memoryLimit.value_or(result.megabytes);
    result.runs = problem.benchmark.runCount.value_or(result.runs);
    result.simplify = problem.benchmark.simplify;
    result.isStopped = isInterrupted;
    result.parameters = parametersOf(given, problem);
    return result;
}

/// The log's file: by default in the problem's output folder, which is made.
std::string logFile(const BenchArguments& given, const Problem& problem) {
    if (!given.log.empty()) return given.log;
    const fs::path folder = fs::path(problem.file).parent_path() / problem.benchmark.outputFolder;
    if (!problem.benchmark.outputFolder.empty()) makeFolder(folder.string());
    return (folder / fs::path(problem.file).filename().replace_extension(".log")).string();
}

Benchmark runShown(const Problem& problem, const Scene& scene, BenchmarkOptions options) {
    std::optional<ElapsedLine> line;
    options.tell = [&](const study::BenchmarkProgress& at) {
        const std::string left = std::isfinite(at.left)
                                     ? fmt::format(", about {:.0f} s left at its start", std::floor(at.left))
                                     : "";
        const std::string words =
            fmt::format("run {} of {}, {}{}, in all", at.run + 1, at.runs, at.planner, left);
        if (line)
            line->tell(words);
        else
            line.emplace(words);
    };
    return study::runBenchmark(problem, scene, options);
}

/// The rank's jobs are the numbers of runs.
study::DoJob jobsOf(const study::DoRun& doRun) {
    return [&doRun](const std::string& number) -> std::optional<std::string> {
        const auto ended = doRun(std::stoul(number));
        return ended ? std::optional(textOf(*ended)) : std::nullopt;
    };
}

void shareOut(const study::SharedRuns& runs, study::Ranks& ranks) {
    std::vector<std::string> numbers;
    for (std::size_t i = 0; i < runs.count; ++i) numbers.push_back(std::to_string(i));
    ranks.share(
        numbers, jobsOf(runs.doRun), [&](const std::string& text) { runs.take(study::readEndedRun(text)); },
        runs.keep);
}

/// For other ranks than 0. Loads the scene after rank 0, which fills the cache of trees and refuses faulty input.
void serve(study::Ranks& ranks, const BenchArguments& given, const Problem& problem) {
    const BenchmarkOptions options = benchmarkOptions(given, problem);
    std::optional<Scene> scene;
    study::DoRun doRun;
    ranks.serve([&](const std::string& number) -> std::optional<std::string> {
        if (isInterrupted()) return std::nullopt;
        if (!scene) {
            scene.emplace(ProblemScenes(problem, given.trees).scene(problem));
            doRun = study::runsOf(problem, *scene, options);
        }
        return jobsOf(doRun)(number);
    });
}

void writeLog(const Benchmark& benchmark, const std::string& log) {
    replaceFile(log, [&](std::ostream& out) { study::writeBenchmarkLog(benchmark, out); });
}

/// Keeps the log up to date while the benchmark runs, so that a killed one leaves most of its runs.
class GrowingLog {
  public:
    explicit GrowingLog(const std::string& log) : log_(log) {}

    void keep(const Benchmark& benchmark) {
        if (benchmark.seconds == seconds_ || secondsSince(written_) < pause_) return;
        const Clock::time_point begin = Clock::now();
        try {
            writeLog(benchmark, log_);
        } catch (const std::runtime_error&) {  // the write at the end reports what stays wrong
        }
        seconds_ = benchmark.seconds;
        written_ = Clock::now();
        pause_ = std::max(kLeastPause, kPausePerWriting * secondsSince(begin));
    }

  private:
    static constexpr double kLeastPause = 10;  ///< seconds
    static constexpr double kPausePerWriting = 100;
    std::string log_;
    double seconds_ = 0, pause_ = kLeastPause;
    Clock::time_point written_ = Clock::now();
};

/// ranks: null unless mpirun started this process.
int benchProblem(const Arguments& arguments, study::Ranks* ranks) {
    const auto isStudy = [](const std::string& argument) { return argument.rfind("--study", 0) == 0; };
    if (std::any_of(arguments.begin(), arguments.end(), isStudy))
        throw std::invalid_argument("--study is a program of its own: clearway-study");
    BenchArguments given;
    if (!readArguments(arguments, given)) return kDone;
    const Problem problem = readProblemFor(given);
    if (ranks && ranks->rank() > 0) return serve(*ranks, given, problem), kDone;
    const std::string log = logFile(given, problem);
    heedInterrupts();  // before files are tried out, so that an interrupt leaves none of them
    OutputFiles files(inputsOf(problem));
    files.add(given.log.empty() ? "the log" : "--log", log);
    requireFactsFile(files);

    BenchmarkOptions options = benchmarkOptions(given, problem);
    const Scene scene = ProblemScenes(problem, given.trees).scene(problem);
    GrowingLog growing(log);
    options.keep = [&](const Benchmark& benchmark) { growing.keep(benchmark); };
    if (ranks) options.share = [&](const study::SharedRuns& runs) { shareOut(runs, *ranks); };
    const Benchmark benchmark = runShown(problem, scene, options);
    writeLog(benchmark, log);

    printWarnings(problem.warnings);
    printBenchmark(benchmark, log);
    if (const auto written = writePaths(benchmark, problem, log))
        printRow("paths", std::to_string(*written) + ", beside the log");
    return benchmark.isComplete() ? kDone : kAnswerIsNo;
}

int mergeBench(const Arguments& arguments) {
    CommandLine line(
        "clearway bench --merge LOG... --log FILE [options]",
        "Joins logs of `clearway bench` that differ in their seeds alone, such as those of a job "
        "array, and names as\n"
        "lost the runs that they announce but do not have, with exit code 1.");
    std::vector<std::string> logs;
    std::string log;
    bool merges = false;
    line.argument("LOG", appendedTo(logs));
    line.argument("[LOG...]", appendedTo(logs));
    line.flag("--merge", "joins the logs", merges);
    line.option("--log FILE", "the joined log", to(log), CommandLine::Count::kRequired);
    addJson(line);
    if (!line.parse(arguments)) return kDone;
    OutputFiles files(logs);
    files.add("--log", log);
    requireFactsFile(files);
    const Benchmark benchmark = study::mergeLogs(logs);
    writeLog(benchmark, log);
    printBenchmark(benchmark, log);
    return benchmark.isComplete() ? kDone : kAnswerIsNo;
}

}  // namespace

int bench(const Arguments& arguments) {
    if (std::find(arguments.begin(), arguments.end(), "--merge") != arguments.end()) {
        if (study::isRank())
            throw std::invalid_argument(
                "--merge was started by mpirun or srun as one of several, expected one process");
        return mergeBench(arguments);
    }
    return runOnRanks([&](study::Ranks* ranks) { return benchProblem(arguments, ranks); });
}

}  // namespace clearway::cli
