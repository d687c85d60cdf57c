// clearway bench: runs a problem's planners, each several times, and writes OMPL's benchmark log.
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <optional>
#include <stdexcept>

#include "clearway/planning/planners.h"
#include "clearway/targets.h"
#include "core/replace_file.h"
#include "program/cli/command_line.h"
#include "program/cli/elapsed_line.h"
#include "program/cli/interrupts.h"
#include "program/cli/planning_scene.h"
#include "program/cli/print.h"
#include "program/cli/study.h"
#include "program/cli/tree_options.h"
#include "program/study/benchmark.h"

namespace clearway::cli {

namespace {

namespace fs = std::filesystem;
using study::Benchmark;
using study::BenchmarkOptions;
using study::BenchmarkRun;
using study::PlannerBenchmark;

CommandLine benchCommandLine() {
    CommandLine commandLine;
    commandLine.usage = "clearway bench PROBLEM.cfg [options]";
    commandLine.purpose =
        "Runs every planner the problem names (without any: RRTConnect, RRT, EST, KPIECE1 and PRM) several "
        "times\nand writes OMPL's benchmark log, for ompl_benchmark_statistics.py and Planner Arena.\n"
        "Ctrl-C leaves a log of the runs that have ended; exit code 1 then.\n"
        "`clearway bench --study leaf-strategies --help` is about studies.";
    commandLine.positional = {"PROBLEM.cfg"};
    commandLine.options.add_options()                                                                  //
        ("log", optionValue("FILE"), "the log (PROBLEM.log, in the problem's output folder)")          //
        ("time", optionValue("S"), "seconds for each run, in place of the problem's time_limit (30)")  //
        ("memory", optionValue("MB"),
         "by which the program may grow, in place of the problem's mem_limit (4096)")            //
        ("runs", optionValue("N"), "of each planner, in place of the problem's run_count (10)")  //
        ("planner", optionValues("NAME"),
         "only this one, with the problem's parameters for it if it names it; may be repeated")          //
        ("seed", optionValue("N"), "of the first run of each planner; each next run's is one more (1)")  //
        ("margin", optionValue("M"),
         "distance to keep from the environment, in place of the problem's margin; its margin.NAME stay")  //
        ("step", optionValue("S"),
         "checks motions at states no farther apart than this, instead of certifying them")  //
        ("ompl-weights", "rotation weighted as OMPL does, not by the part's radius")         //
        ("no-simplify", "leaves paths as the planners found them")                           //
        ("save-paths", optionValue("WHICH"),
         "none, all or shortest (of each planner), beside the log, in place of the problem's save_paths")  //
        ("target", optionValue("NAME"), "instruction set, of those this machine runs (best)");
    addTreeOptions(commandLine);
    addCacheOption(commandLine);
    return commandLine;
}

SavedPaths savedPaths(const Options& options) {
    const std::string which = options.text("save-paths");
    if (which == "none") return SavedPaths::kNone;
    if (which == "all") return SavedPaths::kAll;
    if (which == "shortest") return SavedPaths::kShortest;
    throw std::invalid_argument("--save-paths is '" + which + "', expected none, all or shortest");
}

/// The problem's planners of these names, and one without parameters of each name that it lacks.
std::vector<PlannerChoice> choose(const std::vector<std::string>& names,
                                  const std::vector<PlannerChoice>& planners) {
    std::vector<PlannerChoice> chosen;
    for (const std::string& given : names) {
        const std::string name = planning::plannerClassName(given);
        const std::size_t before = chosen.size();
        for (const PlannerChoice& planner : planners) {
            if (planning::plannerClassName(planner.name) == name) chosen.push_back(planner);
        }
        if (chosen.size() == before) chosen.push_back({name});
    }
    return chosen;
}

/// What the options say goes before what the file says.
Problem readProblemFor(const Options& options) {
    Problem problem = readProblem(options.text("PROBLEM.cfg"));
    if (options.has("margin")) problem.margin = options.nonNegative("margin");
    if (options.has("time")) problem.timeLimit = options.positive("time");
    if (options.has("memory")) problem.memoryLimit = options.positive("memory");
    if (options.has("runs")) problem.runCount = static_cast<int>(options.integer("runs", 1, 1000000));
    if (options.has("planner")) problem.planners = choose(options.texts("planner"), problem.planners);
    if (options.has("save-paths")) problem.savedPaths = savedPaths(options);
    if (options.has("no-simplify")) problem.simplify = false;
    return problem;
}

BenchmarkOptions benchmarkOptions(const Options& options, const Problem& problem) {
    BenchmarkOptions result;
    result.seconds = problem.timeLimit.value_or(result.seconds);
    result.megabytes = problem.memoryLimit.value_or(result.megabytes);
    result.runs = problem.runCount.value_or(result.runs);
    result.simplify = problem.simplify;
    if (options.has("seed")) result.seed = static_cast<std::uint32_t>(options.integer("seed", 1, INT32_MAX));
    if (options.has("step")) result.step = options.positive("step");
    result.omplWeights = options.has("ompl-weights");
    result.isStopped = isInterrupted;
    return result;
}

/// Wrong options before any file is read.
void requireOptions(const Options& options) {
    benchmarkOptions(options, {});
    for (const char* name : {"time", "memory"}) {
        if (options.has(name)) options.positive(name);
    }
    if (options.has("margin")) options.nonNegative("margin");
    if (options.has("runs")) options.integer("runs", 1, 1000000);
    if (options.has("save-paths")) savedPaths(options);
    choose(options.texts("planner"), {});
    if (options.has("target")) useTarget(options.text("target"));
}

/// Refuses one that would replace what is read.
std::string logFile(const Options& options, const Problem& problem) {
    const std::vector<std::string> inputs = inputsOf(problem);
    if (options.has("log")) {
        options.requireOtherFile("log", inputs);
        return options.text("log");
    }
    const fs::path folder = fs::path(problem.file).parent_path() / problem.outputFolder;
    if (!problem.outputFolder.empty()) makeFolder(folder.string());
    const fs::path log = folder / fs::path(problem.file).filename().replace_extension(".log");
    for (const std::string& input : inputs) {
        std::error_code ignored;
        if (!fs::equivalent(log, input, ignored)) continue;
        throw std::invalid_argument("the log would replace the input file '" + input + "', expected --log");
    }
    return log.string();
}

/// As part of a file's name, on any system.
std::string fileName(std::string text) {
    for (char& c : text) {
        const bool isPlain = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
                             c == '-' || c == '.';
        if (!isPlain) c = '_';
    }
    return text;
}

/// Of one planner: EXPERIMENT_PLANNER_RUN.path, runs counted from 0 as OMPL.app does. returns how many.
std::size_t writePaths(const std::string& stem, const PlannerBenchmark& planner, const Problem& problem) {
    std::optional<std::size_t> shortest;
    std::size_t written = 0;
    for (std::size_t i = 0; i < planner.runs.size(); ++i) {
        const BenchmarkRun& run = planner.runs[i];
        if (!run.isSolved) continue;
        if (!shortest || run.length < planner.runs[*shortest].length) shortest = i;
        if (problem.savedPaths != SavedPaths::kAll) continue;
        writePath(run.path, problem.space, stem + "_" + std::to_string(i) + ".path");
        ++written;
    }
    if (problem.savedPaths == SavedPaths::kAll || !shortest) return written;
    writePath(planner.runs[*shortest].path, problem.space, stem + "_" + std::to_string(*shortest) + ".path");
    return 1;
}

void writePaths(const Benchmark& benchmark, const Problem& problem, const std::string& log) {
    if (problem.savedPaths == SavedPaths::kNone) return;
    std::size_t written = 0;
    std::vector<std::string> names;
    for (const PlannerBenchmark& planner : benchmark.planners) {
        std::string name = fileName(benchmark.experiment + "_" + planner.name);
        const auto before = std::count(names.begin(), names.end(), name);
        names.push_back(name);
        if (before > 0) name += "-" + std::to_string(before + 1);
        written += writePaths((fs::path(log).parent_path() / name).string(), planner, problem);
    }
    printRow("paths", std::to_string(written) + ", beside the log");
}

void printPlanner(const PlannerBenchmark& planner) {
    std::vector<double> seconds, lengths;
    for (const BenchmarkRun& run : planner.runs) {
        seconds.push_back(std::stod(run.properties.at("time REAL")));
        if (run.isSolved) lengths.push_back(run.length);
    }
    const auto median = [](std::vector<double>& values) {
        std::nth_element(values.begin(), values.begin() + static_cast<long>(values.size() / 2), values.end());
        return values[values.size() / 2];
    };
    std::string text = std::to_string(lengths.size()) + " of " + counted(seconds.size(), "run") + " solved";
    if (!seconds.empty()) text += ", " + readable(median(seconds)) + " s";
    if (!lengths.empty()) text += ", length " + readable(median(lengths));
    printRow(planner.name, text + (seconds.empty() ? "" : " in the median"));
}

/// So that logs of several kinds of trees can be told apart in one database.
void describeTrees(const BuildOptions& tree, Benchmark& benchmark) {
    benchmark.parameters["general_split VARCHAR"] = tree.generalSplit;
    benchmark.parameters["leaf_split VARCHAR"] = tree.leafSplit;
    benchmark.parameters["leaf_size INTEGER"] = std::to_string(tree.leafSize);
}

Benchmark runShown(const Problem& problem, const Scene& scene, BenchmarkOptions options) {
    std::optional<ElapsedLine> line;
    options.tell = [&](const study::BenchmarkProgress& at) {
        line.reset();
        line.emplace("run " + std::to_string(at.run + 1) + " of " + std::to_string(at.runs) + ", " +
                     at.planner + ", about " + std::to_string(static_cast<long>(at.left)) +
                     " s left at its start, running");
    };
    return study::runBenchmark(problem, scene, options);
}

}  // namespace

int bench(const Arguments& arguments) {
    const auto isStudy = [](const std::string& argument) { return argument.rfind("--study", 0) == 0; };
    if (std::any_of(arguments.begin(), arguments.end(), isStudy)) return study(arguments);
    const std::optional<Options> given = parse(benchCommandLine(), arguments);
    if (!given) return kDone;
    const Options& options = *given;
    requireOptions(options);
    const BuildOptions tree = treeOptions(options);
    const std::string cache = cacheFolder(options);
    const Problem problem = readProblemFor(options);
    const std::string log = logFile(options, problem);
    requireReplaceable(log);
    heedInterrupts();

    const BenchmarkOptions benchmarkGiven = benchmarkOptions(options, problem);
    planning::PlanOptions reaching;
    reaching.step = benchmarkGiven.step;
    const Scene scene = buildScene(problem, reaching, tree, cache);
    Benchmark benchmark = runShown(problem, scene, benchmarkGiven);
    describeTrees(tree, benchmark);
    replaceFile(log, [&](std::ostream& out) { study::writeBenchmarkLog(benchmark, out); });

    printWarnings(problem.warnings);
    printWarnings(benchmark.warnings);
    printRow("experiment", benchmark.experiment);
    for (const PlannerBenchmark& planner : benchmark.planners) printPlanner(planner);
    writePaths(benchmark, problem, log);
    printRow("took", readable(benchmark.seconds) + " s" +
                         (benchmark.isComplete ? "" : ", interrupted: the log has the runs that ended"));
    printRow("log", log);
    requirePrinted();
    return benchmark.isComplete ? kDone : kAnswerIsNo;
}

}  // namespace clearway::cli
