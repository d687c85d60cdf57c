#include "program/bench/benchmark_log.h"

#include <ompl/base/PlannerStatus.h>
#include <ompl/config.h>

#include <ostream>
#include <set>

namespace clearway::study {
namespace {

/// "1.5.2". OMPL_VERSION is an empty text in Debian 12.
std::string omplVersion() {
    return std::to_string(OMPL_MAJOR_VERSION) + "." + std::to_string(OMPL_MINOR_VERSION) + "." +
           std::to_string(OMPL_PATCH_VERSION);
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
        << options.secondsLimit() << " seconds per run\n"
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
