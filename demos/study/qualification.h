// Which planners enter which problems: a planner that seldom finds a path in the time has no time to a path that trees could change.
#pragma once

#include <string>
#include <vector>

#include "demos/study/planner_runs.h"
#include "demos/study/table.h"

namespace clearway::study {

constexpr double kLeastSolved =
    0.8;  ///< share of the seeds; a planner enters, and a cell has ratios, from here on
constexpr double kLimitOverMedian = 10;    ///< of the paired runs' limit over the qualifying median
constexpr std::size_t kLeastProblems = 3;  ///< a planner that enters fewer is unable

/// The outcomes of a planner's qualifying runs on a problem: for each seed, the seconds to its path or nothing.
using Outcomes = std::vector<Measure>;

/// Whether further seeds cannot change that the planner does not enter, or all seeds have run.
bool isDecided(const Outcomes& outcomes, const StudyOptions& options);

/// A row of qualified.csv: a planner and a problem.
struct QualifiedRow {
    std::string scene, planner;
    std::uint64_t runs = 0, solved = 0;
    Measure
        medianSeconds;  ///< of all runs, those without a path counted as the slowest; empty when that is one of them
    std::string verdict;   ///< enters; or why not: "solves too few", "too slow"
    Measure limitSeconds;  ///< of the paired runs; empty unless it enters
    /// The number of paired runs in each tree; 0 unless it enters, and for the slowest where the study's minutes do not suffice.
    std::uint64_t seeds = 0;

    bool enters() const { return limitSeconds.has_value(); }
};

Columns<QualifiedRow> qualifiedColumns();
QualifiedRow judge(const std::string& scene, const std::string& planner, const Outcomes& outcomes,
                   const StudyOptions& options);

/// The planners that enter fewer than kLeastProblems problems; where there are fewer problems, those that enter none.
std::vector<std::string> unablePlanners(const std::vector<QualifiedRow>& rows, const StudyOptions& options);

/// Sets the rows' seeds so that paired runs take at most these seconds of all processes together: options.seeds, or half as many, or
/// none for the slowest rows.
void fitSeeds(std::vector<QualifiedRow>& rows, const StudyOptions& options, double seconds);

}  // namespace clearway::study
