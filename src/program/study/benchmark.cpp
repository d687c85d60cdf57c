#include "program/study/benchmark.h"

#include <ompl/tools/benchmark/MachineSpecs.h>
#include <ompl/util/Time.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <filesystem>
#include <sstream>
#include <stdexcept>

#include "clearway/planning/ompl_messages.h"
#include "clearway/planning/plan_setup.h"
#include "core/number.h"
#include "program/study/benchmark_run.h"

namespace clearway::study {
namespace {

using Clock = std::chrono::steady_clock;

using planning::PlanOptions;
using planning::PlanReport;
using planning::PlanSetup;

/// One of each kind: two trees, one tree, by density, by projection, a roadmap.
constexpr const char* kDefaultPlanners[] = {"RRTConnect", "RRT", "EST", "KPIECE1", "PRM"};
constexpr double kBytesPerMegabyte = 1024.0 * 1024.0;
constexpr double kMostMegabytes = 1e12;  ///< more than any machine has, less than the type of bytes holds

double secondsSince(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

void requireOptions(const BenchmarkOptions& options) {
    if (!(options.seconds > 0)) {
        throw std::invalid_argument("the time limit is " + shortNumber(options.seconds) +
                                    ", expected seconds above 0");
    }
    if (!(options.megabytes > 0)) {
        throw std::invalid_argument("the memory limit is " + shortNumber(options.megabytes) +
                                    ", expected megabytes above 0");
    }
    if (options.runs < 1) {
        throw std::invalid_argument("the number of runs is " + std::to_string(options.runs) +
                                    ", expected at least 1");
    }
}

/// The log's reader takes the last word of a line for the name.
std::string experimentName(const Problem& problem) {
    std::string name = problem.name;
    if (name.empty()) name = std::filesystem::path(problem.file).stem().string();
    for (char& c : name) {
        if (std::isspace(static_cast<unsigned char>(c))) c = '_';
    }
    return name.empty() ? "NO_NAME" : name;
}

/// The problem once for each planner, which it then names alone.
std::vector<Problem> problemsOf(const Problem& problem) {
    std::vector<PlannerChoice> planners = problem.planners;
    if (planners.empty()) {
        for (const char* name : kDefaultPlanners) planners.push_back({name, {}});
    }
    std::vector<Problem> problems(planners.size(), problem);
    for (std::size_t i = 0; i < planners.size(); ++i) problems[i].planners = {planners[i]};
    return problems;
}

PlanOptions planOptions(const BenchmarkOptions& options, int run) {
    PlanOptions result;
    result.seconds = options.seconds;
    result.threads = 1;
    result.seed = options.seed + static_cast<std::uint32_t>(run);
    result.step = options.step;
    result.omplWeights = options.omplWeights;
    return result;
}

void addOnce(std::vector<std::string>& warnings, const std::vector<std::string>& more) {
    for (const std::string& warning : more) {
        if (std::find(warnings.begin(), warnings.end(), warning) == warnings.end())
            warnings.push_back(warning);
    }
}

/// Everything that can be wrong with a planner is, before the first run; and what the log says of it.
PlannerBenchmark describePlanner(const Problem& problem, const Scene& scene, const BenchmarkOptions& options,
                                 Benchmark& benchmark) {
    PlanReport report;
    const PlanSetup setup = planning::makePlanSetup(problem, scene, planOptions(options, 0), report);
    addOnce(benchmark.warnings, report.warnings);
    const ompl::base::Planner& planner = *setup.planners[0];
    PlannerBenchmark result;
    result.name = "geometric_" + planner.getName();
    planner.params().getParams(result.settings);
    setup.si->params().getParams(result.settings);
    for (const auto& property : planner.getPlannerProgressProperties()) {
        result.progressNames.push_back(property.first);
    }
    if (!result.progressNames.empty()) result.progressNames.push_back("time REAL");
    std::sort(result.progressNames.begin(), result.progressNames.end());

    std::ostringstream text;
    if (benchmark.planners.empty()) setup.si->printSettings(text);
    planner.printProperties(text);
    benchmark.setup += text.str();
    return result;
}

BenchmarkProgress progressAt(const Benchmark& benchmark, std::size_t planner, int run, double elapsed) {
    const BenchmarkOptions& options = benchmark.options;
    BenchmarkProgress progress;
    progress.planner = benchmark.planners[planner].name;
    progress.run = static_cast<int>(planner) * options.runs + run;
    progress.runs = static_cast<int>(benchmark.planners.size()) * options.runs;
    const double each = progress.run > 0 ? elapsed / progress.run : options.seconds;
    progress.left = each * (progress.runs - progress.run);
    return progress;
}

Benchmark begin(const Problem& problem, const BenchmarkOptions& options) {
    Benchmark benchmark;
    benchmark.options = options;
    benchmark.experiment = experimentName(problem);
    benchmark.parameters["margin REAL"] = shortNumber(problem.margin);
    benchmark.host = ompl::machine::getHostname();
    benchmark.cpu = ompl::machine::getCPUInfo();
    benchmark.started = ompl::time::as_string(ompl::time::now());
    benchmark.setup = "Problem: " + problem.file + "\n";
    return benchmark;
}

/// False when it was stopped.
bool runAll(const std::vector<Problem>& problems, const Scene& scene, Benchmark& benchmark) {
    const BenchmarkOptions& options = benchmark.options;
    const auto bytesBefore = ompl::machine::getProcessMemoryUsage();
    const RunLimits limits{options.seconds,
                           bytesBefore + static_cast<unsigned long long>(
                                             std::min(options.megabytes, kMostMegabytes) * kBytesPerMegabyte),
                           options.simplify, options.isStopped};
    const Clock::time_point start = Clock::now();
    for (std::size_t i = 0; i < problems.size(); ++i) {
        for (int run = 0; run < options.runs; ++run) {
            if (options.tell) options.tell(progressAt(benchmark, i, run, secondsSince(start)));
            const auto result =
                runOnce(problems[i], scene, planOptions(options, run), limits, benchmark.warnings);
            if (!result) return false;
            benchmark.planners[i].runs.push_back(*result);
        }
    }
    return true;
}

}  // namespace

Benchmark runBenchmark(const Problem& problem, const Scene& scene, const BenchmarkOptions& options) {
    requireOptions(options);
    const planning::OmplMessages messages;
    Benchmark benchmark = begin(problem, options);
    const Clock::time_point start = Clock::now();
    const std::vector<Problem> problems = problemsOf(problem);
    for (const Problem& each : problems) {
        benchmark.planners.push_back(describePlanner(each, scene, options, benchmark));
    }
    benchmark.isComplete = runAll(problems, scene, benchmark);
    benchmark.seconds = secondsSince(start);
    std::vector<std::string> heard;
    for (const std::string& warning : messages.warnings()) heard.push_back("OMPL: " + warning);
    addOnce(benchmark.warnings, heard);
    return benchmark;
}

}  // namespace clearway::study
