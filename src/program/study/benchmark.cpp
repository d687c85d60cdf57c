#include "program/study/benchmark.h"

#include <ompl/base/PlannerStatus.h>
#include <ompl/config.h>
#include <ompl/tools/benchmark/MachineSpecs.h>
#include <ompl/util/Time.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <filesystem>
#include <ostream>
#include <set>
#include <sstream>
#include <stdexcept>

#include "clearway/planning/ompl_messages.h"
#include "clearway/planning/plan_setup.h"
#include "core/number.h"

namespace clearway::study {
namespace {

using planning::PlanOptions;
using planning::PlanReport;
using planning::PlanSetup;

/// One planner of each kind: two trees, one tree, by density, by projection, a roadmap.
constexpr const char* kDefaultPlanners[] = {"RRTConnect", "RRT", "EST", "KPIECE1", "PRM"};
constexpr double kMostMegabytes = 1e12;  ///< more than any machine has; in bytes the integer type holds it

/// "1.5.2". OMPL_VERSION is an empty text in Debian 12.
std::string omplVersion() {
    return std::to_string(OMPL_MAJOR_VERSION) + "." + std::to_string(OMPL_MINOR_VERSION) + "." +
           std::to_string(OMPL_PATCH_VERSION);
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

/// Makes the planner once, so that its mistakes show before the first run, and describes it for the log.
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

/// Returns false when the benchmark was stopped.
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

/// Replaces the separators: OMPL's script splits values of runs at "; ", values of progress at commas and
/// semicolons, and settings at line ends.
std::string without(const std::string& separators, std::string value, char instead) {
    for (char& c : value) {
        if (separators.find(c) != std::string::npos) c = instead;
    }
    return value;
}

std::string line(const std::string& value) {
    return without("\n\r", value, ' ');
}

/// Writes lines between the marks, each with its end.
void writeText(const std::string& text, std::ostream& out) {
    out << "<<<|\n" << text << (text.empty() || text.back() == '\n' ? "" : "\n") << "|>>>\n";
}

void writeHead(const Benchmark& benchmark, std::ostream& out) {
    out << "OMPL version " << omplVersion() << "\nExperiment " << benchmark.experiment << "\n"
        << benchmark.parameters.size() << " experiment properties\n";
    for (const auto& [name, value] : benchmark.parameters) out << name << " = " << line(value) << "\n";
    out << "Running on " << (benchmark.host.empty() ? "UNKNOWN" : benchmark.host) << "\nStarting at "
        << benchmark.started << "\n";
    writeText(benchmark.setup, out);
    writeText(benchmark.cpu, out);
    const BenchmarkOptions& options = benchmark.options;
    out << options.seed << " is the random seed\n"
        << options.seconds << " seconds per run\n"
        << options.megabytes << " MB per run\n"
        << options.runs << " runs per planner\n"
        << benchmark.seconds << " seconds spent to collect the data\n1 enum type\nstatus";
    for (int i = 0; i < static_cast<int>(ompl::base::PlannerStatus::TYPE_COUNT); ++i) {
        out << "|"
            << ompl::base::PlannerStatus(static_cast<ompl::base::PlannerStatus::StatusType>(i)).asString();
    }
    out << "\n";
}

/// Writes the runs' values. A run without a value gets an empty text in its place.
void writeRuns(const PlannerBenchmark& planner, std::ostream& out) {
    std::set<std::string> names;
    for (const BenchmarkRun& run : planner.runs) {
        for (const auto& property : run.properties) names.insert(property.first);
    }
    out << names.size() << " properties for each run\n";
    for (const std::string& name : names) out << name << "\n";
    out << planner.runs.size() << " runs\n";
    for (const BenchmarkRun& run : planner.runs) {
        for (const std::string& name : names) {
            const auto found = run.properties.find(name);
            // The script takes "inf" and "nan" for no value, but "-inf" for a word.
            if (found != run.properties.end() && found->second != "-inf") {
                out << without(";", line(found->second), ',');
            }
            out << "; ";
        }
        out << "\n";
    }
}

void writeProgress(const PlannerBenchmark& planner, std::ostream& out) {
    if (planner.progressNames.empty()) return;
    out << planner.progressNames.size() << " progress properties for each run\n";
    for (const std::string& name : planner.progressNames) out << name << "\n";
    out << planner.runs.size() << " runs\n";
    for (const BenchmarkRun& run : planner.runs) {
        for (const Properties& moment : run.progress) {
            for (const std::string& name : planner.progressNames) {
                const auto found = moment.find(name);
                if (found != moment.end()) out << without(",;", line(found->second), ' ');
                out << ",";
            }
            out << ";";
        }
        out << "\n";
    }
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

void writeBenchmarkLog(const Benchmark& benchmark, std::ostream& out) {
    writeHead(benchmark, out);
    out << benchmark.planners.size() << " planners\n";
    for (const PlannerBenchmark& planner : benchmark.planners) {
        out << line(planner.name) << "\n" << planner.settings.size() << " common properties\n";
        for (const auto& [name, value] : planner.settings) out << name << " = " << line(value) << "\n";
        writeRuns(planner, out);
        writeProgress(planner, out);
        out << ".\n";
    }
}

}  // namespace clearway::study
