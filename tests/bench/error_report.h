// The speed and the errors of each mode, as rows of a CSV file.
#pragma once

#include <string>
#include <vector>

#include "bench/modes.h"
#include "bench/near_margin.h"

namespace clearway::testing {

/// The spread of values over the poses that have one, in shares of the scene's size.
struct Spread {
    std::size_t count = 0;
    double median = 0, p999 = 0, worst = 0;
};

struct VerdictCounts {
    int falseValid = 0;    ///< poses called valid although the distance is not larger than the margin
    int falseInvalid = 0;  ///< poses called invalid although the distance is larger
};

struct ModeFigures {
    std::string mode;
    bool isQuery = false;
    double queriesPerSecond = 0;
    double overFloatOnly = 0;        ///< time relative to float only, from the median repetition of each pose
    std::vector<double> passRatios;  ///< this ratio for whole passes, one value per repetition
    Spread errors;                   ///< |answer - true distance|; verdicts have none
    Spread widths;                   ///< upper - lower, where there is an interval
    int beyondCap = 0;               ///< answers "farther than the cap": they have no number and no width
    int outside = 0;                 ///< intervals that do not hold the true distance
    std::vector<VerdictCounts> verdicts;  ///< one per margin
};

struct ErrorReport {
    std::string scene, about;
    std::size_t poses = 0, colliding = 0;
    std::vector<PosesNearMargin> margins;
    std::vector<double> marginShares;  ///< shares of the scene's size
    std::vector<ModeFigures> modes;
};

Spread spreadOf(std::vector<double> values);

/// Judges a mode that has run; truths: the true distances at its poses. sceneSize: a length.
ModeFigures figuresOf(const Mode& mode, const Series& floatOnly, const std::vector<Truth>& truths,
                      double sceneSize);

/// Lists the wrong answers of the library itself, one line per kind: intervals that miss the true distance;
/// poses called valid that touch or are no farther than the margin; and for isWithin valid poses called
/// invalid.
std::vector<std::string> faults(const ErrorReport& report);

std::string errorHeader(const std::vector<double>& marginShares);
std::string errorRows(const ErrorReport& report);

}  // namespace clearway::testing
