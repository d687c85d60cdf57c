// The command line of bench_queries.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "bench/bench_scenes.h"
#include "bench/builds.h"
#include "bench/series.h"

namespace clearway::testing {

struct BenchChoices {
    std::vector<std::string> scenes;       ///< letters; empty when files are given
    std::string part, environment, poses;  ///< files; empty when scenes are chosen
    bool small = false;
    std::optional<std::size_t> partTriangles, environmentTriangles;
    int poseCount = 0;
    std::uint64_t seed = 1;
    Schedule schedule;
    BuildSchedule builds;
    bool withPeers = true;
    std::vector<std::string> targets;  ///< instruction sets besides the best one
    BuildOptions trees;
    std::size_t oraclePoses = 0;
    std::string out;  ///< folder; empty for none
};

/// Nothing when help was asked for, which is then printed. Throws std::invalid_argument or what
/// boost::program_options throws for what makes no sense.
std::optional<BenchChoices> readOptions(int count, char** words, std::ostream& help);

}  // namespace clearway::testing
