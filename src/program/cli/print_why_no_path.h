// How `plan` shows why there is no path: one fact a row, then hints of what to try.
#pragma once

#include "clearway/planning/explain.h"
#include "clearway/planning/why_no_path.h"
#include "clearway/problem.h"
#include "clearway/scene.h"

namespace clearway::cli {

/// Prints rows about how far the part comes, what stops it, and the nearest miss.
void printWhyNoPath(const planning::WhyNoPath& why);

/// Prints rows about what would have to go for a path to be found. largestMargin: of the scene, environment units.
void printExplanation(const planning::Explanation& explanation, double largestMargin);

/// Options that the user set already, so that no hint names them.
struct AskedFor {
    bool isExplained = false;
    bool hasNearest = false;  ///< as a path or a page
};

/// Prints a row for each option or key of the problem file that may help.
void printHints(const planning::WhyNoPath& why, const Problem& problem, const Scene& scene,
                const AskedFor& asked);

}  // namespace clearway::cli
