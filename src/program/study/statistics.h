// From the study's tables to what strategies change: figures of each tree and planner, and ratios to the
// first leaf split of the same planner, tree and seed.
#pragma once

#include <string>
#include <vector>

#include "program/study/planner_runs.h"
#include "program/study/replay.h"
#include "program/study/table.h"

namespace clearway::study {

/// values: at least one. Of an even number, the mean of the two in the middle.
double median(std::vector<double> values);

/// How much more or less one strategy takes than another, told apart from luck: the median of ratios of
/// pairs, and how sure that median is.
/// Source: Efron, Bootstrap Methods, 1979.
struct PairedRatio {
    double median = 0;         ///< of the clusters' medians
    double low = 0, high = 0;  ///< 95 in 100 resamples have their median in this interval
    std::uint64_t pairs = 0;
    std::uint64_t clusters = 0;
};

/// clusters: for each run the ratios of its pairs; empty ones do not count. Clusters are drawn whole, for
/// pairs of one run are not independent, and weigh alike, for the number of a run's pairs says nothing of its
/// worth. Equal numbers give equal answers. All is 0 without any pair.
PairedRatio pairedRatio(const std::vector<std::vector<double>>& clusters);

/// A row of statistics.csv, about a measure with a leaf split and with the baseline. The planner "all" stands
/// for the calls of all planners.
struct StatisticRow : CallsRow, PairedRatio {
    std::string source;  ///< runs or replay
    std::string measure;
    std::string baseline;  ///< a leaf split
};

/// scene, source, the engine's columns without the leaf split, planner, measure; leaf_split, baseline; ratio,
/// low, high, pairs, clusters.
Columns<StatisticRow> statisticColumns();

/// For runs, the measures are first_solution_seconds, seconds_per_call (the processor's) and
/// query_seconds_per_call (a call is a state or motion that the planner asked about), cost,
/// volume_tests_per_query, triangle_tests_per_query, block_fill and kernel_fill (see SummaryRow). A pair is
/// two runs of a seed; a pair with a disturbed run has no ratio of times by the clock. When one run of a pair
/// found nothing, its first solution counts as found at its end, which brings the ratio nearer to 1 than it
/// is.
///
/// For replays, they are seconds, volume_tests, triangle_tests, block_fill and kernel_fill; a pair is a
/// block, a cluster a run.
std::vector<StatisticRow> statisticsOf(const std::vector<RunRow>& runs, const std::vector<ReplayRow>& replays,
                                       const std::string& baseline);

/// A row of summary.csv: figures of a tree and planner, or of "all" planners. For replays only the columns
/// from callsPerSecond on, without queryShare.
struct SummaryRow : CallsRow {
    std::string source;  ///< runs or replay
    Count runs, solved;
    Count disturbed;  ///< see RunRow::wasDisturbed
    /// Medians of the solved runs.
    Measure firstSolutionSeconds, finalSolutionSeconds, cost;
    /// Means of a run.
    Measure stateChecks, motionChecks, motionCosts, distanceQueries, withinQueries;
    Measure callsPerSecond;              ///< of the processor
    Measure queryShare;                  ///< of the runs' seconds
    Measure volumeTests, triangleTests;  ///< per query
    Measure blockFill;                   ///< the share in use of blocks of pairs of triangles
    Measure kernelFill;                  ///< the share in use of the lanes of the full kernel
};

Columns<SummaryRow> summaryColumns();
std::vector<SummaryRow> summaryOf(const std::vector<RunRow>& runs, const std::vector<ReplayRow>& replays);

}  // namespace clearway::study
