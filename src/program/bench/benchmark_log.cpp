#include "program/bench/benchmark_log.h"

#include <fmt/format.h>
#include <ompl/base/PlannerStatus.h>
#include <ompl/config.h>

#include <boost/algorithm/string/finder.hpp>
#include <boost/algorithm/string/iter_find.hpp>
#include <climits>
#include <cmath>
#include <ostream>
#include <set>
#include <stdexcept>

#include "core/number.h"
#include "core/text.h"

namespace clearway::study {
namespace {

/// "1.5.2". OMPL_VERSION is an empty text in Debian 12.
std::string omplVersion() {
    return fmt::format("{}.{}.{}", OMPL_MAJOR_VERSION, OMPL_MINOR_VERSION, OMPL_PATCH_VERSION);
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

std::vector<std::string> split(const std::string& text, const std::string& separator) {
    std::vector<std::string> parts;
    return boost::iter_split(parts, text, boost::first_finder(separator));
}

/// The lines of a log, which are read one by one.
class Lines {
  public:
    explicit Lines(const std::string& file) : file_(file), lines_(readLines(file, "a benchmark log")) {}

    const std::string& next(const std::string& expected) {
        if (next_ == lines_.size())
            throw std::runtime_error(
                fmt::format("{}: ends after {} lines, expected {}", file_, next_, expected));
        return lines_[next_++];
    }

    bool isNext(const std::string& line) const { return next_ < lines_.size() && lines_[next_] == line; }

    void takeEnd() {
        if (next_ < lines_.size()) next(""), refuse("the end of the log");
    }

    void take(const std::string& expected) {
        if (next(quote(expected)) != expected) refuse(quote(expected));
    }

    /// The rest of the line after the words that it must begin with.
    std::string after(const std::string& words) {
        const std::string& line = next(quote(words));
        if (line.compare(0, words.size(), words) != 0) refuse(quote(words));
        return line.substr(words.size());
    }

    /// The number before the words that the line must end with.
    double before(const std::string& words) {
        const std::string expected = "a number and " + quote(words), line = next(expected);
        const std::size_t space = line.find(' ');
        const std::string number = line.substr(0, space);
        const auto value = number == "inf" ? HUGE_VAL : parseNumber(number);
        if (!value || space == std::string::npos || line.substr(space + 1) != words) refuse(expected);
        return *value;
    }

    int count(const std::string& words) {
        const double value = before(words);
        if (!(value >= 0 && value <= INT_MAX && value == std::floor(value))) refuse("a whole number");
        return static_cast<int>(value);
    }

    /// Calls `read` as often as the line says.
    template <class Read>
    void repeat(const std::string& words, const Read& read) {
        for (int left = count(words); left > 0; --left) read();
    }

    /// Reads lines "name = value".
    Properties values(const std::string& words) {
        Properties values;
        repeat(words, [&] {
            const std::string line = next("name = value");
            const std::size_t equals = line.find(" = ");
            if (equals == std::string::npos || equals + 3 == line.size()) refuse("name = value");
            values[line.substr(0, equals)] = line.substr(equals + 3);
        });
        return values;
    }

    /// The lines between the two marks.
    std::string text() {
        take("<<<|");
        std::string all;
        while (!isNext("|>>>")) all += next("'|>>>'") + "\n";
        take("|>>>");
        return all;
    }

    /// Reads names of several words, the last of which is an SQL type.
    std::vector<std::string> typedNames(const std::string& words) {
        std::vector<std::string> names;
        repeat(words, [&] {
            names.push_back(next("a name and its type"));
            const std::string type = names.back().substr(names.back().rfind(' ') + 1);
            if (kTypes.count(type) == 0 || names.back() == type) refuse("a name and its type");
        });
        return names;
    }

    /// One value for each name, each followed by the separator. A name without a value is left out.
    Properties valuesOf(const std::vector<std::string>& names, const std::string& text,
                        const std::string& separator) const {
        const std::vector<std::string> parts = split(text, separator);
        if (parts.size() != names.size() + 1 || !parts.back().empty())
            refuse(std::to_string(names.size()) + " values");
        Properties values;
        for (std::size_t i = 0; i < names.size(); ++i) {
            if (!parts[i].empty()) values[names[i]] = parts[i];
        }
        return values;
    }

    [[noreturn]] void refuse(const std::string& expected) const {
        throw std::runtime_error(place(file_, static_cast<int>(next_)) + quote(lines_[next_ - 1]) +
                                 ", expected " + expected);
    }

  private:
    inline static const std::set<std::string> kTypes = {"REAL", "INTEGER", "BOOLEAN",
                                                        "ENUM", "VARCHAR", "TEXT"};
    std::string file_;
    std::vector<std::string> lines_;
    std::size_t next_ = 0;
};

BenchmarkRun readRun(const Properties& properties) {
    BenchmarkRun run;
    run.properties = properties;
    const auto value = [&](const char* name) {
        const auto found = properties.find(name);
        return found == properties.end() ? std::nullopt : parseNumber(found->second);
    };
    run.isSolved = value("solved BOOLEAN") == 1.0;
    run.length = value("simplified solution length REAL").value_or(value("solution length REAL").value_or(0));
    return run;
}

PlannerBenchmark readPlanner(Lines& lines) {
    PlannerBenchmark planner;
    planner.name = lines.next("a planner");
    planner.settings = lines.values("common properties");
    const auto names = lines.typedNames("properties for each run");
    lines.repeat("runs",
                 [&] { planner.runs.push_back(readRun(lines.valuesOf(names, lines.next("a run"), "; "))); });
    if (!lines.isNext(".")) {
        planner.progressNames = lines.typedNames("progress properties for each run");
        lines.take(std::to_string(planner.runs.size()) + " runs");
        for (BenchmarkRun& run : planner.runs) {
            std::vector<std::string> moments = split(lines.next("a run's progress"), ";");
            if (!moments.back().empty()) lines.refuse("a semicolon at the end");
            moments.pop_back();
            for (const std::string& moment : moments)
                run.progress.push_back(lines.valuesOf(planner.progressNames, moment, ","));
        }
    }
    lines.take(".");
    return planner;
}

}  // namespace

Benchmark readBenchmarkLog(const std::string& file) {
    Lines lines(file);
    Benchmark log;
    BenchmarkOptions& options = log.options;
    lines.take("OMPL version " + omplVersion());
    log.experiment = lines.after("Experiment ");
    log.parameters = lines.values("experiment properties");
    log.host = lines.after("Running on ");
    log.started = lines.after("Starting at ");
    log.setup = lines.text();
    log.cpu = lines.text();
    options.seed = static_cast<std::uint32_t>(lines.count("is the random seed"));
    options.seconds = lines.before("seconds per run");
    options.megabytes = lines.before("MB per run");
    options.runs = lines.count("runs per planner");
    log.seconds = lines.before("seconds spent to collect the data");
    lines.take("1 enum type");
    lines.after("status|");
    lines.repeat("planners", [&] { log.planners.push_back(readPlanner(lines)); });
    lines.takeEnd();
    return log;
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
