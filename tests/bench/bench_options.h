// The command line of bench_queries.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "bench/builds.h"
#include "bench/task_options.h"

namespace clearway::testing {

/// Without scenes when files are given.
struct BenchChoices : TaskChoices {
    std::string part, environment, poses;  ///< files; empty when scenes are chosen
    BuildSchedule builds;
    std::vector<std::string> targets;  ///< instruction sets besides the best one
    BuildOptions trees;
    std::size_t oraclePoses = 0;
};

/// Nothing when help was asked for, which is then printed. Throws std::invalid_argument or what
/// boost::program_options throws for what makes no sense.
std::optional<BenchChoices> readOptions(int count, char** words, std::ostream& help);

}  // namespace clearway::testing
