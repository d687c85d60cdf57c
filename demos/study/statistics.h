// Computes from the study's tables how strategies differ: figures of each tree and planner, and ratios to the
// first leaf split with equal planner, tree and seed.
#pragma once

#include <string>
#include <vector>

#include "demos/study/planner_runs.h"
#include "demos/study/replay.h"
#include "program/bench/table.h"

namespace clearway::study {

/// The median; for an even number of values, the mean of the two in the middle. values: at least one.
double median(std::vector<double> values);

/// The ratio between two strategies: the median of the ratios of pairs, and an interval that says how sure
/// the median is.
/// Source: Efron, Bootstrap Methods, 1979.
struct PairedRatio {
    double median = 0;         ///< median of the clusters' medians
    double low = 0, high = 0;  ///< interval that holds the median of 95 in 100 resamples
    std::uint64_t pairs = 0;
    std::uint64_t clusters = 0;
};

/// clusters: the ratios of each run's pairs; empty clusters do not count. A resample draws whole clusters,
/// because pairs of one run are not independent. All clusters weigh equally, because many pairs do not make a
/// run more reliable. Equal numbers give equal answers. Without any pair all fields are 0.
PairedRatio pairedRatio(const std::vector<std::vector<double>>& clusters);

/// A row of statistics.csv: one measure, with a leaf split and with the baseline. The planner "all" stands
/// for the calls of all planners.
struct StatisticRow : CallsRow, PairedRatio {
    std::string source;  ///< runs or replay
    std::string measure;
    std::string baseline;  ///< the leaf split that the row's split is compared with
};

/// scene, source, the engine's columns without the leaf split, planner, measure; leaf_split, baseline; ratio,
/// low, high, pairs, clusters.
Columns<StatisticRow> statisticColumns();

/// For runs, the measures are first_solution_seconds, seconds_per_call (processor time),
/// query_seconds_per_call, cost, volume_tests_per_query, triangle_tests_per_query, block_fill and kernel_fill
/// (see SummaryRow). A call is a state or motion that the planner asked about. A pair is two runs of one
/// seed; a pair with a disturbed run has no ratio of clock times. When only one run of a pair found a path,
/// the other's first solution counts as found at its end, which brings the ratio nearer to 1 than it is.
///
/// For replays, the measures are seconds, volume_tests, triangle_tests, block_fill and kernel_fill. A pair is
/// a block, a cluster is a run.
std::vector<StatisticRow> statisticsOf(const std::vector<RunRow>& runs, const std::vector<ReplayRow>& replays,
                                       const std::string& baseline);

/// A row of summary.csv: figures of a tree and planner, or of "all" planners. Rows of replays have only the
/// columns from callsPerSecond on, without queryShare.
struct SummaryRow : CallsRow {
    std::string source;  ///< runs or replay
    Count runs, solved;
    Count disturbed;  ///< see RunRow::wasDisturbed
    /// Medians of the solved runs.
    Measure firstSolutionSeconds, finalSolutionSeconds, cost;
    /// Means over the runs.
    Measure stateChecks, motionChecks, motionCosts, distanceQueries, withinQueries;
    Measure callsPerSecond;              ///< per second of processor time
    Measure queryShare;                  ///< share of the runs' seconds
    Measure volumeTests, triangleTests;  ///< per query
    Measure blockFill;                   ///< share of places in use, in blocks of pairs of triangles
    Measure kernelFill;                  ///< share of register lanes in use, in the full kernel
};

Columns<SummaryRow> summaryColumns();
std::vector<SummaryRow> summaryOf(const std::vector<RunRow>& runs, const std::vector<ReplayRow>& replays);

}  // namespace clearway::study
