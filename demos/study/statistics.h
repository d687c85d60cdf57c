// Computes from the study's tables how trees differ: figures of each cell (scene, planner, tree), and ratios between trees with equal
// scene, planner and seed.
#pragma once

#include <string>
#include <vector>

#include "demos/study/files.h"
#include "demos/study/planner_runs.h"
#include "demos/study/replay.h"
#include "demos/study/table.h"

namespace clearway::study {

/// The median; for an even number of values, the mean of the two in the middle. values: at least one.
double median(std::vector<double> values);

/// The ratio between two trees: the median of the ratios of pairs, and an interval that says how sure the median is.
/// Source: Efron, Bootstrap Methods, 1979.
struct PairedRatio {
    double median = 0;         ///< of the pairs
    double low = 0, high = 0;  ///< interval that holds the median of 95 in 100 resamples
    std::uint64_t pairs = 0;
};

/// A resample draws whole pairs. Equal numbers give equal answers. Without any pair all fields are 0.
PairedRatio pairedRatio(const std::vector<double>& ratios);

/// Microseconds of processor time for each unit of work, fitted to a scene's replays: non-negative least squares of the relative errors.
struct WorkCosts {
    double volumeTest = 0, trianglePair = 0, kernelLane = 0, call = 0;
    double error = 0;  ///< root mean square of the relative errors
};
WorkCosts fitCosts(const std::vector<ReplayRow>& replays);

/// The tables, as far as they concern one study.
struct Measured {
    std::vector<FilesRow> files;
    std::vector<RunRow> runs;
    std::vector<ReplayRow> replays;
};

/// A row of cells.csv. Times are medians of the runs that found a path, in seconds.
struct CellRow : CallsRow {
    std::uint64_t runs = 0, solved = 0;
    Measure filesToPath;  ///< loading, building both trees, planning
    Measure planning;     ///< to the first path
    Measure calls, queries;
    Measure querySeconds, queryShare;
    /// Shares of the planning time, by the scene's fitted costs; the rest is spent elsewhere.
    Measure volumeShare, triangleShare;
    Measure leavesRatio;  ///< leaves of both trees over those with the first leaf split
    /// The number of seeds with which the planner did the same as in the qualifying tree: see didTheSame().
    std::uint64_t equalQuestions = 0;
};

/// Whether a planner made the same decisions in two trees: both runs checked as many states and motions, grew graphs of one size, and found
/// paths of exactly one length. The clock, or distances in their last digits, can make a planner decide otherwise.
bool didTheSame(const RunRow& a, const RunRow& b);

Columns<CellRow> cellColumns();
std::vector<CellRow> cellsOf(const Measured& measured, const StudyOptions& options);

/// A row of ratios.csv: a measure in a tree over that in another tree. planner: "all" for replays.
struct RatioRow : CallsRow, PairedRatio {
    std::string source;  ///< runs or replay
    std::string measure;
    std::string baseline;  ///< the other tree, "sah/none"; it differs in the splits alone
};

/// Each tree is compared with the tree of its general split without leaf splits, and with the qualifying tree.
///
/// A pair of runs has one seed, and both found a path. For runs the measures are files_to_path, planning, queries (seconds in them),
/// volume_tests and triangle_tests, of pairs that did the same; and files_to_path_any and planning_any, of all pairs, in which luck counts,
/// too. A pair with a disturbed run has no ratio of times. There is no ratio where a tree solved fewer than kLeastSolved of its seeds, or
/// fewer than half of them have a pair. For replays the measures are seconds, volume_tests and triangle_tests. A pair is a sample of
/// calls, of any planner.
Columns<RatioRow> ratioColumns();
std::vector<RatioRow> ratiosOf(const Measured& measured, const StudyOptions& options);

}  // namespace clearway::study
