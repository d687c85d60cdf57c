// Asks every query about a small case and holds the answers to what include/clearway/query.h promises, by
// exact arithmetic.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "clearway/query.h"
#include "torture/truth.h"

namespace clearway::testing {

/// The last arithmetic that a query needed.
enum class Stage { kFloat, kDouble, kDoubleDouble, kExact };
constexpr int kStages = 4;
Stage stageOf(const QueryCounters& counters);

/// The answer of the finish in double alone, before any later stage; for one triangle against one.
struct DoubleFinish {
    bool isAsked = false;
    long double error = 0;  ///< of the distance of its two points
    long double width = 0;  ///< of its interval
};

/// Triangles at least this high over their longest edge are regular: the double finish is off by no more than
/// so many u64 (M + L) of the distance between them.
constexpr double kRegularFlatness = 0.01;
constexpr double kFinishRoundoffs = 16;

struct CheckedCase {
    CaseLengths lengths;
    long double truth = 0;  ///< rounded; 0 exactly for contact
    long double error = 0;  ///< of `distance`
    long double width = 0;  ///< of its interval
    double allowedWidth = 0;
    Stage ofDistance = Stage::kFloat;
    Stage ofCollides = Stage::kFloat;
    std::vector<Stage> ofWithin;  ///< at the truth and the doubles beside it
    DoubleFinish finish;
    bool isRefused = false;               ///< as the documents say: the sizes differ too much
    std::vector<std::string> complaints;  ///< a line for each promise broken
};

/// The widest an interval may be without options.
double defaultWidth(const CaseLengths& lengths);

/// choices: which options and distances are asked for besides the ones always asked for.
CheckedCase checkCase(const PosedMeshes& posed, std::uint64_t choices);

}  // namespace clearway::testing
