// The options that the benchmarks share: which scenes, how many poses, how many repetitions.
#pragma once

#include <boost/program_options.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bench/bench_scenes.h"
#include "bench/series.h"

namespace clearway::testing {

struct TaskChoices {
    std::vector<std::string> scenes;  ///< letters
    bool small = false;
    std::optional<std::size_t> partTriangles, environmentTriangles;
    int poseCount = 0;
    std::uint64_t seed = 1;
    Schedule schedule;
    bool withPeers = true;
    std::string out;  ///< folder; empty: writes no files
};

/// scenes: the default, as letters separated by commas. outFiles: names the files in --out, for the help
/// text.
void addTaskOptions(boost::program_options::options_description& all, const std::string& scenes,
                    const std::string& outFiles);

/// Throws std::invalid_argument, naming the option, its value and what was expected.
TaskChoices taskChoices(const boost::program_options::variables_map& given);

/// The option's value. Throws std::invalid_argument if it is less than `least` or no number.
int atLeast(int least, const boost::program_options::variables_map& given, const char* option);
double atLeast(double least, const boost::program_options::variables_map& given, const char* option);

std::vector<std::string> splitAtCommas(const std::string& list);
std::string allSceneNames();

BenchTask makeTask(const TaskChoices& choices, const std::string& scene);

}  // namespace clearway::testing
