// The options that the benchmarks share: which scenes, how many poses, how many repetitions.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bench/bench_scenes.h"
#include "bench/series.h"
#include "program/options/command_line.h"

namespace clearway::testing {

struct TaskChoices {
    std::vector<std::string> scenes;  ///< the scenes' letters
    bool small = false;
    std::optional<std::size_t> partTriangles, environmentTriangles;
    int poseCount = 200;
    std::uint64_t seed = 1;
    Schedule schedule;
    bool withoutPeers = false;
    std::string out;                       ///< folder; empty: writes no files
    std::string part, environment, poses;  ///< files; empty when scenes are chosen
};

/// Declares the options that fill `to`. By default the scenes stay as they are. outFiles: the files that
/// --out will hold, for the help text.
void addTaskOptions(cli::CommandLine& line, const std::string& outFiles, TaskChoices& to);

/// Declares --part, --environment and --poses, files in place of scenes.
void addFileOptions(cli::CommandLine& line, TaskChoices& to);

/// With files the scenes become none. Throws std::invalid_argument if only some of the files are given.
void requireFiles(TaskChoices& choices);

std::vector<std::string> splitAtCommas(const std::string& list);
std::vector<std::string> allSceneNames();

BenchTask makeTask(const TaskChoices& choices, const std::string& scene);

BenchTask taskFromFiles(const TaskChoices& choices);

/// Writes a table into a folder, which it makes if need be; without a folder nothing. Throws std::runtime_error if the
/// file cannot be written.
void writeTable(const std::string& folder, const std::string& file, const std::string& table);

}  // namespace clearway::testing
