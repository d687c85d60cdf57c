// From the study's tables to figures of each tree and planner.
#pragma once

#include <string>
#include <vector>

#include "program/study/growing_table.h"

namespace clearway::study {

/// scene, source, the engine's columns, planner; of runs: their number, solved, disturbed (see
/// wasDisturbed); medians of those solved: first_solution_seconds, final_solution_seconds, cost; means of a
/// run: state_checks, motion_checks, motion_costs, distance_queries, within_queries; calls_per_second (of
/// the processor), query_share. Per query volume_tests and triangle_tests; block_fill and kernel_fill: the
/// share in use of blocks of pairs of triangles, and of the lanes of the full kernel.
std::vector<std::string> summaryColumns();
std::vector<TableRow> summaryOf(const std::vector<TableRow>& runs, const std::vector<TableRow>& replays);

}  // namespace clearway::study
