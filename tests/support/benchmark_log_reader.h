// Reads OMPL's benchmark logs line by line, as strictly as its statistics script does.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace clearway::testing {

struct ReadLog {
    using Values = std::map<std::string, std::string>;
    struct Planner {
        std::string name;
        Values settings;
        std::vector<Values> runs;
        std::vector<std::vector<Values>> progress;  ///< one list for each run, moment by moment
    };

    std::string version, experiment, host, started, setup, cpu;
    Values parameters;
    long seed = 0, runsPerPlanner = 0;
    double secondsPerRun = 0, megabytesPerRun = 0, seconds = 0;
    std::vector<std::string> statuses;
    std::vector<Planner> planners;
};

/// Throws std::runtime_error, which names the line, if a line is not what the script needs.
ReadLog readBenchmarkLog(const std::string& text);

}  // namespace clearway::testing
