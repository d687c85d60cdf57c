// From the study's tables to what strategies change, as ratios to the first leaf split of the same planner,
// tree and seed.
#pragma once

#include <string>
#include <vector>

#include "program/study/growing_table.h"

namespace clearway::study {

/// scene, source (runs or replay), the engine's columns without the leaf split, planner ("all": of all
/// planners), measure; leaf_split, baseline; ratio, low, high (see PairedRatio), pairs, clusters.
std::vector<std::string> statisticsColumns();

/// Of runs the measures first_solution_seconds, seconds_per_call (of the processor) and
/// query_seconds_per_call (a call is a state or motion that the planner asked about), cost,
/// volume_tests_per_query, triangle_tests_per_query, block_fill and kernel_fill (see summaryColumns). A pair
/// is two runs of a seed; one with a disturbed run has no ratio of times by the clock. Of two runs of which
/// one found nothing, that one's first solution counts as found at its end, which brings the ratio nearer to
/// 1 than it is. Of replays seconds, volume_tests, triangle_tests, block_fill and kernel_fill; a pair is a
/// block, a cluster a run.
std::vector<TableRow> statisticsOf(const std::vector<TableRow>& runs, const std::vector<TableRow>& replays,
                                   const std::string& baseline);

}  // namespace clearway::study
