#include "support/benchmark_log_reader.h"

#include <sstream>
#include <stdexcept>

namespace clearway::testing {
namespace {

std::vector<std::string> split(const std::string& text, const std::string& separator) {
    std::vector<std::string> parts;
    std::size_t begin = 0;
    for (std::size_t end; (end = text.find(separator, begin)) != std::string::npos;) {
        parts.push_back(text.substr(begin, end - begin));
        begin = end + separator.size();
    }
    parts.push_back(text.substr(begin));
    return parts;
}

class Lines {
  public:
    explicit Lines(const std::string& text) : stream_(text) {}

    std::string next() {
        std::string line;
        ++number_;
        if (!std::getline(stream_, line)) refuse("another line", "the end");
        return line;
    }

    /// The rest of the line after the words that it must begin with.
    std::string after(const std::string& words) {
        const std::string line = next();
        if (line.compare(0, words.size(), words) != 0) refuse("'" + words + "'", line);
        return line.substr(words.size());
    }

    /// The number before the words that the line must end with.
    double before(const std::string& words) {
        const std::string line = next();
        const std::size_t space = line.find(' ');
        if (space == std::string::npos || line.substr(space + 1) != words) {
            refuse("a number and '" + words + "'", line);
        }
        return number(line.substr(0, space));
    }

    long count(const std::string& words) { return static_cast<long>(before(words)); }

    /// Reads a line "name = value".
    void value(ReadLog::Values& values) {
        const std::string line = next();
        const std::size_t equals = line.find(" = ");
        if (equals == std::string::npos || equals + 3 == line.size()) refuse("name = value", line);
        values[line.substr(0, equals)] = line.substr(equals + 3);
    }

    /// The lines between the two marks.
    std::string text() {
        if (next() != "<<<|") refuse("<<<|", "another");
        std::string all;
        for (std::string line = next(); line != "|>>>"; line = next()) all += line + "\n";
        return all;
    }

    /// Reads a name of several words, the last of which is an SQL type.
    std::string typedName() {
        const std::string line = next();
        const std::string type = line.substr(line.rfind(' ') + 1);
        for (const char* known : {"REAL", "INTEGER", "BOOLEAN", "ENUM", "VARCHAR", "TEXT"}) {
            if (type == known && line.size() > type.size() + 1) return line;
        }
        refuse("a name and its type", line);
    }

    std::string nextOr(const std::string& line) {
        const auto place = stream_.tellg();
        const std::string found = next();
        if (found == line) return found;
        stream_.seekg(place);
        --number_;
        return found;
    }

    [[noreturn]] void refuse(const std::string& expected, const std::string& found) const {
        throw std::runtime_error("line " + std::to_string(number_) + " is '" + found + "', expected " +
                                 expected);
    }

  private:
    double number(const std::string& text) const {
        std::size_t end = 0;
        const double value = std::stod(text, &end);
        if (end != text.size()) refuse("a number", text);
        return value;
    }

    std::istringstream stream_;
    int number_ = 0;
};

std::vector<std::string> readNames(Lines& lines, const std::string& words) {
    std::vector<std::string> names(static_cast<std::size_t>(lines.count(words)));
    for (std::string& name : names) name = lines.typedName();
    return names;
}

/// One value for each name, each followed by the separator.
ReadLog::Values valuesOf(const std::vector<std::string>& names, const std::string& text,
                         const std::string& separator, const Lines& lines) {
    std::vector<std::string> parts = split(text, separator);
    if (parts.size() != names.size() + 1 || !parts.back().empty()) {
        lines.refuse(std::to_string(names.size()) + " values", text);
    }
    ReadLog::Values values;
    for (std::size_t i = 0; i < names.size(); ++i) values[names[i]] = parts[i];
    return values;
}

void readProgress(Lines& lines, ReadLog::Planner& planner) {
    const std::vector<std::string> names = readNames(lines, "progress properties for each run");
    planner.progress.resize(static_cast<std::size_t>(lines.count("runs")));
    if (planner.progress.size() != planner.runs.size()) lines.refuse("as many runs as above", "another");
    for (auto& run : planner.progress) {
        std::vector<std::string> moments = split(lines.next(), ";");
        if (!moments.back().empty()) lines.refuse("a semicolon at the end", moments.back());
        moments.pop_back();
        for (const std::string& moment : moments) run.push_back(valuesOf(names, moment, ",", lines));
    }
}

ReadLog::Planner readPlanner(Lines& lines) {
    ReadLog::Planner planner;
    planner.name = lines.next();
    const long settings = lines.count("common properties");
    for (long i = 0; i < settings; ++i) lines.value(planner.settings);
    const std::vector<std::string> names = readNames(lines, "properties for each run");
    const long runs = lines.count("runs");
    for (long i = 0; i < runs; ++i) planner.runs.push_back(valuesOf(names, lines.next(), "; ", lines));
    if (lines.nextOr(".") == ".") return planner;
    readProgress(lines, planner);
    if (lines.next() != ".") lines.refuse("a dot", "another");
    return planner;
}

}  // namespace

ReadLog readBenchmarkLog(const std::string& text) {
    Lines lines(text);
    ReadLog log;
    log.version = "OMPL " + lines.after("OMPL version ");
    log.experiment = lines.after("Experiment ");
    if (log.experiment.empty() || log.experiment.find(' ') != std::string::npos) {
        lines.refuse("a name of one word", log.experiment);
    }
    const long parameters = lines.count("experiment properties");
    for (long i = 0; i < parameters; ++i) lines.value(log.parameters);
    log.host = lines.after("Running on ");
    log.started = lines.after("Starting at ");
    log.setup = lines.text();
    log.cpu = lines.text();
    log.seed = lines.count("is the random seed");
    log.secondsPerRun = lines.before("seconds per run");
    log.megabytesPerRun = lines.before("MB per run");
    log.runsPerPlanner = lines.count("runs per planner");
    log.seconds = lines.before("seconds spent to collect the data");
    if (lines.next() != "1 enum type") lines.refuse("1 enum type", "another");
    log.statuses = split(lines.after("status|"), "|");
    log.planners.resize(static_cast<std::size_t>(lines.count("planners")));
    for (ReadLog::Planner& planner : log.planners) planner = readPlanner(lines);
    return log;
}

}  // namespace clearway::testing
