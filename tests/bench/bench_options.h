// The command line of bench_queries.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "bench/builds.h"
#include "bench/task_options.h"

namespace clearway::testing {

/// If files are given, `scenes` is empty.
struct BenchChoices : TaskChoices {
    std::string part, environment, poses;  ///< files; empty when scenes are chosen
    BuildSchedule builds;
    std::vector<std::string> targets;  ///< instruction sets besides the best one
    BuildOptions trees;
    std::size_t oraclePoses = 0;
};

/// Reads the command line. If it asks for help, prints the help and returns nothing. Throws
/// std::invalid_argument, or an exception of boost::program_options, for an option that makes no sense.
std::optional<BenchChoices> readOptions(int count, char** words, std::ostream& help);

}  // namespace clearway::testing
