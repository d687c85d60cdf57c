#include "program/bench/benchmark.h"

#include <ompl/tools/benchmark/MachineSpecs.h>
#include <ompl/util/Time.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <sstream>

#include "clearway/planning/ompl_messages.h"
#include "core/clock.h"
#include "core/number.h"
#include "planning/plan/plan_setup.h"

namespace clearway::study {
namespace {

using planning::PlanOptions;
using planning::PlanReport;
using planning::PlanSetup;

/// One planner of each kind: two trees, one tree, by density, by projection, a roadmap.
constexpr const char* kDefaultPlanners[] = {"RRTConnect", "RRT", "EST", "KPIECE1", "PRM"};
constexpr double kMostMegabytes = 1e12;  ///< more than any machine has; in bytes the integer type holds it

/// A name without white space, because the log's reader takes the last word of its line.
std::string experimentName(const Problem& problem) {
    std::string name = problem.name;
    if (name.empty()) name = std::filesystem::path(problem.file).stem().string();
    for (char& c : name) {
        if (std::isspace(static_cast<unsigned char>(c))) c = '_';
    }
    return name.empty() ? "NO_NAME" : name;
}

/// A copy of the problem for each planner. Each copy names one planner alone.
std::vector<Problem> problemsOf(const Problem& problem) {
    std::vector<PlannerChoice> planners = problem.planning.planners;
    if (planners.empty()) {
        for (const char* name : kDefaultPlanners) planners.push_back({name, {}});
    }
    std::vector<Problem> problems(planners.size(), problem);
    for (std::size_t i = 0; i < planners.size(); ++i) problems[i].planning.planners = {planners[i]};
    return problems;
}

PlanOptions planOptions(const BenchmarkOptions& options, int run) {
    PlanOptions result;
    if (options.iterations) {
        result.iterations = options.iterations;
    } else {
        result.seconds = options.seconds;
    }
    result.threads = 1;
    result.seed = options.seed + static_cast<std::uint32_t>(run);
    result.omplWeights = options.omplWeights;
    return result;
}

void addOnce(std::vector<std::string>& warnings, const std::vector<std::string>& more) {
    for (const std::string& warning : more) {
        if (std::find(warnings.begin(), warnings.end(), warning) == warnings.end())
            warnings.push_back(warning);
    }
}

/// By the process's memory before its first run.
RunLimits limitsOf(const BenchmarkOptions& options) {
    const double growth = std::min(options.megabytes, kMostMegabytes) * kBytesPerMegabyte;
    RunLimits limits;
    limits.seconds = options.secondsLimit();
    limits.iterations = options.iterations;
    limits.bytes = ompl::machine::getProcessMemoryUsage() + static_cast<unsigned long long>(growth);
    limits.simplify = options.simplify;
    limits.isStopped = options.isStopped;
    return limits;
}

/// Makes the planner once, so that its mistakes show before the first run, and describes it for the log.
PlannerBenchmark describePlanner(const Problem& problem, const Scene& scene, const BenchmarkOptions& options,
                                 Benchmark& benchmark) {
    PlanReport report;
    const PlanSetup setup = planning::makePlanSetup(problem, scene, planOptions(options, 0), report);
    addOnce(benchmark.warnings, report.warnings);
    if (options.iterations && !report.isRepeatable) {
        addOnce(benchmark.warnings, {report.planners[0] + " does not give the same path again with the same "
                                                          "seed and number of iterations"});
    }
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

BenchmarkProgress progressAt(const Benchmark& benchmark, std::size_t planner, std::size_t ended) {
    BenchmarkProgress progress;
    progress.planner = benchmark.planners[planner].name;
    progress.run = static_cast<int>(ended);
    progress.runs = static_cast<int>(benchmark.planners.size()) * benchmark.options.runs;
    const double each = ended > 0 ? benchmark.seconds / progress.run : benchmark.options.secondsLimit();
    progress.left = each * (progress.runs - progress.run);
    return progress;
}

Benchmark begin(const Problem& problem, const BenchmarkOptions& options) {
    Benchmark benchmark;
    benchmark.options = options;
    for (int run = 0; run < options.runs; ++run) benchmark.seeds.insert(planOptions(options, run).seed);
    benchmark.experiment = experimentName(problem);
    benchmark.parameters = options.parameters;
    benchmark.parameters["margin REAL"] = shortNumber(problem.margin);
    if (options.iterations) benchmark.parameters["iterations INTEGER"] = std::to_string(*options.iterations);
    benchmark.host = ompl::machine::getHostname();
    benchmark.cpu = ompl::machine::getCPUInfo();
    benchmark.started = ompl::time::as_string(ompl::time::now());
    benchmark.setup = "Problem: " + problem.file + "\n";
    return benchmark;
}

/// Does all runs, or has them shared out.
void doRuns(const DoRun& doRun, Benchmark& benchmark) {
    const BenchmarkOptions& options = benchmark.options;
    const Clock::time_point start = Clock::now();
    const auto runs = static_cast<std::size_t>(options.runs);
    std::size_t ended = 0;
    SharedRuns shared;
    shared.count = benchmark.planners.size() * runs;
    shared.doRun = [&](std::size_t number) {
        if (options.tell) options.tell(progressAt(benchmark, number / runs, ended));
        return doRun(number);
    };
    shared.take = [&](const EndedRun& run) {
        addRun(run.run, benchmark.planners.at(run.number / runs));
        addOnce(benchmark.warnings, run.warnings);
        benchmark.seconds = secondsSince(start);
        ++ended;
    };
    shared.keep = [&] {
        if (options.keep) options.keep(benchmark);
    };
    if (options.share) return options.share(shared);
    for (std::size_t number = 0; number < shared.count; ++number) {
        const auto run = shared.doRun(number);
        if (!run) return;
        shared.take(*run);
        shared.keep();
    }
}

}  // namespace

bool Benchmark::isComplete() const {
    return std::all_of(planners.begin(), planners.end(),
                       [&](const PlannerBenchmark& planner) { return missingSeeds(planner, *this).empty(); });
}

Benchmark runBenchmark(const Problem& problem, const Scene& scene, const BenchmarkOptions& options) {
    const planning::OmplMessages messages;
    Benchmark benchmark = begin(problem, options);
    const Clock::time_point start = Clock::now();
    for (const Problem& each : problemsOf(problem)) {
        benchmark.planners.push_back(describePlanner(each, scene, options, benchmark));
    }
    doRuns(runsOf(problem, scene, options), benchmark);
    benchmark.seconds = secondsSince(start);
    std::vector<std::string> heard;
    for (const std::string& warning : messages.warnings()) heard.push_back("OMPL: " + warning);
    addOnce(benchmark.warnings, heard);
    return benchmark;
}

DoRun runsOf(const Problem& problem, const Scene& scene, const BenchmarkOptions& options) {
    return [problems = problemsOf(problem), limits = limitsOf(options), &scene,
            &options](std::size_t number) -> std::optional<EndedRun> {
        const auto runs = static_cast<std::size_t>(options.runs);
        EndedRun ended;
        ended.number = number;
        const auto run =
            runOnce(problems.at(number / runs), scene, planOptions(options, static_cast<int>(number % runs)),
                    limits, ended.warnings);
        if (!run) return std::nullopt;
        ended.run = *run;
        return ended;
    };
}

std::uint32_t seedOf(const BenchmarkRun& run) {
    return static_cast<std::uint32_t>(std::stoul(run.properties.at("seed INTEGER")));
}

std::set<std::uint32_t> missingSeeds(const PlannerBenchmark& planner, const Benchmark& benchmark) {
    std::set<std::uint32_t> missing = benchmark.seeds;
    for (const BenchmarkRun& run : planner.runs) missing.erase(seedOf(run));
    return missing;
}

bool addRun(const BenchmarkRun& run, PlannerBenchmark& planner) {
    const auto place =
        std::lower_bound(planner.runs.begin(), planner.runs.end(), seedOf(run),
                         [](const BenchmarkRun& one, std::uint32_t seed) { return seedOf(one) < seed; });
    if (place != planner.runs.end() && seedOf(*place) == seedOf(run)) return false;
    planner.runs.insert(place, run);
    return true;
}

}  // namespace clearway::study
