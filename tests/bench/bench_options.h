// The command line of `benchmarks queries`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/builds.h"
#include "bench/task_options.h"

namespace clearway::testing {

struct BenchChoices : TaskChoices {
    BuildSchedule builds;
    std::vector<std::string> targets;  ///< instruction sets besides the best one
    BuildOptions trees;
    std::size_t oraclePoses = 3;
};

/// Prints the help and returns nothing when it is asked for. Throws std::invalid_argument that names a wrong
/// option, its value and what was expected.
std::optional<BenchChoices> readOptions(int count, char** words);

}  // namespace clearway::testing
