// What strategies alone change: the calls that planners' runs recorded, asked again of every engine.
#pragma once

#include <string>
#include <vector>

#include "program/study/growing_table.h"
#include "program/study/study_options.h"
#include "program/study/study_problem.h"

namespace clearway::study {

/// scene and engineColumns(); planner, seed, block; calls, seconds and work of the block.
std::vector<std::string> replayColumns();

/// Replays the folder's samples, of slow planners a part (see replayedBlocks), with the groups of engines
/// that the table lacks, a group at a time. Within a group the engines take turns, sample by sample, and each
/// block's time is the median of the repetitions, the processor's. runs: of the planners, all of them. False
/// when it was stopped: then the group at hand is not in the table.
///
/// Every call must answer alike everywhere; that a motion is undecided with one engine is no contradiction,
/// and is told. Throws std::logic_error that names engines and call when one says yes and another says no.
bool replayCalls(const StudyProblem& problem, const StudyOptions& options, const std::string& folder,
                 const std::vector<TableRow>& runs, GrowingTable& replays);

}  // namespace clearway::study
