#include "program/study/benchmark_log.h"

#include <ompl/base/PlannerStatus.h>
#include <ompl/config.h>

#include <algorithm>
#include <ostream>
#include <set>

namespace clearway::study {
namespace {

namespace ob = ompl::base;

/// "1.5.2". OMPL_VERSION is an empty text in Debian 12.
std::string omplVersion() {
    return std::to_string(OMPL_MAJOR_VERSION) + "." + std::to_string(OMPL_MINOR_VERSION) + "." +
           std::to_string(OMPL_PATCH_VERSION);
}

/// The script splits values of runs at "; ", of progress at commas and semicolons, of settings at line ends.
std::string without(const std::string& separators, std::string value, char instead) {
    for (char& c : value) {
        if (separators.find(c) != std::string::npos) c = instead;
    }
    return value;
}

std::string line(const std::string& value) {
    return without("\n\r", value, ' ');
}

/// Lines between the marks, each with its end.
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
    for (int i = 0; i < static_cast<int>(ob::PlannerStatus::TYPE_COUNT); ++i) {
        out << "|" << ob::PlannerStatus(static_cast<ob::PlannerStatus::StatusType>(i)).asString();
    }
    out << "\n";
}

/// A run that lacks a value has an empty one in its place.
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
            // "inf" and "nan" are no value to the script, "-inf" is a word.
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
