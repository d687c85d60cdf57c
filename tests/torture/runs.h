// The run itself: family after family, round after round, until there is enough.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "torture/figures.h"

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

/// Tells the progress on standard error, and on standard output the first violation of each family with its
/// smallest repeat.
std::vector<PairFigures> runPairs(const TortureOptions& options);
std::vector<MeshFigures> runMeshes(const TortureOptions& options);

}  // namespace clearway::testing
