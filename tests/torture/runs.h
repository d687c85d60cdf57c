// The torture run: family after family, round after round, until the asked number of cases or time is
// reached.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "torture/figures.h"

namespace clearway::testing {

struct TortureOptions {
    std::uint64_t pairs = 0, poses = 0;  ///< over all families together
    double minutes = 0;                  ///< used unless pairs or poses are given
    std::uint64_t seed = 1;
    std::vector<std::string> families;  ///< empty: all
    bool withFcl = true;
    bool resting = false;
    std::string csv;
};

/// Prints progress on standard error; prints the first violation of each family with its smallest repeat on
/// standard output.
std::vector<PairFigures> runPairs(const TortureOptions& options);
std::vector<MeshFigures> runMeshes(const TortureOptions& options);

}  // namespace clearway::testing
