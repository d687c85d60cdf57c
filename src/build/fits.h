// The table of fits: how the volume of a node is chosen. A new one is one file and one row.
#pragma once

#include <string>

#include "build/fit/covariance.h"
#include "build/fit/fit_input.h"
#include "build/fit/frames.h"

namespace clearway {

/// An RSS that holds all of the node's points. The same input gives the same volume, whatever the scratch was
/// used for before.
using Fit = Rss (*)(const FitInput& node, FitScratch& scratch);

struct NamedFit {
    const char* name;
    Fit fit;
};

constexpr NamedFit kFits[] = {
    {"frames", fitLeastOfFrames},
    {"covariance", fitByCovariance},
};

/// Throws std::invalid_argument that lists the known names.
const NamedFit& fitNamed(const std::string& name);

}  // namespace clearway
