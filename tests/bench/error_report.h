// How fast and how wrong each mode was, as text and as CSV.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "bench/modes.h"
#include "bench/near_margin.h"

namespace clearway::testing {

/// Over the poses that have one; shares of the scene's size.
struct Spread {
    std::size_t count = 0;
    double median = 0, p999 = 0, worst = 0;
};

struct VerdictCounts {
    int falseValid = 0;    ///< said valid, but the distance is not larger than the margin
    int falseInvalid = 0;  ///< the other way round
};

struct ModeFigures {
    std::string mode;
    bool isQuery = false;
    double queriesPerSecond = 0;
    double overFloatOnly = 0;             ///< time over float only's: of each pose the median repetition
    std::vector<double> passRatios;       ///< likewise of whole passes, one value a repetition
    Spread errors;                        ///< |answer - true distance|; not of verdicts
    Spread widths;                        ///< upper - lower, where there is an interval
    int beyondCap = 0;                    ///< answered by "farther than the cap": no number, no width
    int outside = 0;                      ///< intervals that do not hold the true distance
    std::vector<VerdictCounts> verdicts;  ///< one a margin
};

struct ErrorReport {
    std::string scene, about;
    std::size_t poses = 0, colliding = 0;
    std::vector<PosesNearMargin> margins;
    std::vector<double> marginShares;  ///< of the scene's size
    std::vector<ModeFigures> modes;
};

Spread spreadOf(std::vector<double> values);

/// Of a mode that has run at the poses whose truths these are. sceneSize: a length.
ModeFigures figuresOf(const Mode& mode, const Series& floatOnly, const std::vector<Truth>& truths,
                      double sceneSize);

/// Answers of the library itself that are wrong: intervals that miss the truth, and poses that touch, or are
/// no farther than the margin, called valid; for isWithin also the other way round. A line each kind.
std::vector<std::string> faults(const ErrorReport& report);

void print(std::ostream& out, const ErrorReport& report);

std::string errorHeader(const std::vector<double>& marginShares);
std::string errorRows(const ErrorReport& report);

}  // namespace clearway::testing
