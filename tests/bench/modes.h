// The ways to measure a distance whose speed and errors are compared.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bench/bench_scenes.h"
#include "bench/clearway_series.h"
#include "bench/series.h"

namespace clearway::testing {

constexpr const char* kFloatOnly = "float only";
constexpr const char* kDefault = "default";

/// The cap of the mode `cap`, as a share of the scene's size.
constexpr double kCapShare = 0.01;
constexpr double kTimedMargin = 1e-3;

struct Mode {
    /// How an answer decides that a pose is valid at a margin: lower exceeds the margin, the number exceeds
    /// the margin, or the verdict says so.
    enum class Says { kInterval, kLowerBound, kNumber, kVerdict };

    Says says;
    bool isQuery = false;  ///< a query of the library itself, whose wrong answers are faults
    Series series;         ///< `engine` is the mode's name
    std::function<bool(const Pose&, double margin)> isValid;

    const std::string& name() const { return series.engine; }
    bool isProved() const { return says != Says::kNumber; }
};

/// Makes these modes: scalar double, float only, the default, relative errors of 0.001, 0.01 and 0.1, the
/// cap, isWithin (timed at a margin of kTimedMargin), the bound of the root volumes, and every peer that
/// answers distances. Modes that keep a warm start use it.
std::vector<Mode> makeModes(const BenchTask& task, const TreePair& trees, const std::vector<Peer>& peers);

}  // namespace clearway::testing
