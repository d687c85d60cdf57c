// Asks every query about a small case and checks the answers, in exact arithmetic, against the promises of
// include/clearway/query.h.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "clearway/query.h"
#include "torture/truth.h"

namespace clearway::testing {

/// The last stage of arithmetic that a query needed.
enum class Stage { kFloat, kDouble, kDoubleDouble, kExact };
constexpr int kStages = 4;
Stage stageOf(const QueryCounters& counters);

/// The answer of the resolution in double alone, before any later stage, for one triangle against one.
struct DoubleFinish {
    bool isAsked = false;
    long double error = 0;  ///< error of the distance between its two points
    long double width = 0;  ///< width of its interval
};

/// Triangles are regular if their height is at least this share of their longest edge. For regular triangles
/// the distance from the resolution in double is off by at most kFinishRoundoffs u64 (M + L).
constexpr double kRegularFlatness = 0.01;
constexpr double kFinishRoundoffs = 16;

struct CheckedCase {
    CaseLengths lengths;
    long double truth = 0;  ///< rounded; 0 exactly on contact
    long double error = 0;  ///< error of `distance`
    long double width = 0;  ///< width of its interval
    double allowedWidth = 0;
    Stage ofDistance = Stage::kFloat;
    Stage ofCollides = Stage::kFloat;
    std::vector<Stage> ofWithin;  ///< isWithin at the truth and at the doubles beside it
    DoubleFinish finish;
    bool isRefused = false;               ///< refused, as documented, because the sizes differ too much
    std::vector<std::string> complaints;  ///< one line per broken promise
};

/// The largest width an interval may have with default options.
double defaultWidth(const CaseLengths& lengths);

/// choices: seed of the options and distances that are asked for in addition to the fixed ones.
CheckedCase checkCase(const PosedMeshes& posed, std::uint64_t choices);

}  // namespace clearway::testing
