// What the torture program can be told.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace clearway::testing {

struct TortureOptions {
    std::uint64_t pairs = 0, poses = 0;  ///< of all families together
    double minutes = 0;                  ///< unless pairs or poses say how many
    std::uint64_t seed = 1;
    std::vector<std::string> families;  ///< empty: all
    bool withFcl = true;
    bool resting = false;
    std::string csv;
};

/// Nothing when help was asked for and printed. Throws std::invalid_argument naming a value that is wrong and
/// what was expected, std::runtime_error when the CSV cannot be written.
std::optional<TortureOptions> readOptions(int argc, char** argv);

}  // namespace clearway::testing
