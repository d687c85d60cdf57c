// From the study's tables to what strategies change, as ratios to the first leaf split of the same planner,
// tree and seed.
#pragma once

#include <string>
#include <vector>

#include "study/growing_table.h"

namespace clearway {

/// scene, source (runs or replay), the engine's columns without the leaf split, planner ("all": of all
/// planners), measure; leaf_split, baseline; ratio, low, high (see PairedRatio), pairs, clusters.
std::vector<std::string> statisticsColumns();

/// Of runs the measures first_solution_seconds and cost (of pairs that have both), and seconds_per_call; a
/// pair is two runs of a seed. Of replays seconds, volume_tests and triangle_tests; a pair is a block, a
/// cluster a run.
std::vector<TableRow> statisticsOf(const std::vector<TableRow>& runs, const std::vector<TableRow>& replays,
                                   const std::string& baseline);

/// scene, source, the engine's columns, planner; runs, solved, first_solution_seconds (median of those
/// solved), calls_per_second, query_share, and per query volume_tests, triangle_tests; block_fill,
/// kernel_fill (shares of lanes).
std::vector<std::string> summaryColumns();
std::vector<TableRow> summaryOf(const std::vector<TableRow>& runs, const std::vector<TableRow>& replays);

}  // namespace clearway
