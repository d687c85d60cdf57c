// Measures the effect of strategies alone: the calls that planners' runs recorded, asked again of every
// engine.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "program/study/experiment.h"
#include "program/study/planner_runs.h"
#include "program/study/table.h"

namespace clearway::study {

/// A row of replay.csv: the work of one block of calls.
struct ReplayRow : CallsRow, Work {
    std::uint64_t calls = 0;
    double seconds = 0;  ///< the processor's
};

/// scene and engineColumns(); planner, seed, block; calls, seconds and work of the block.
Columns<ReplayRow> replayColumns();

/// Replays the folder's samples, a part of them for slow planners (see replayedBlocks), with the groups of
/// engines that the table lacks, a group at a time. Within a group the engines take turns, sample by sample,
/// and each block's time is the median of the repetitions. runs: all rows of the planners' runs. Returns
/// false when it was stopped: then the group at hand is not in the table.
///
/// Every call must have one answer with all engines. That a motion is undecided with one engine only is no
/// contradiction, and is reported. Throws std::logic_error that names engines and call when one says yes and
/// another says no.
bool replayCalls(const StudyProblem& problem, const StudyOptions& options, const std::string& folder,
                 const std::vector<RunRow>& runs, GrowingTable<ReplayRow>& replays);

/// The seconds of a planner's call: the median of the runs with that seed. 0 without runs.
double querySecondsPerCall(const std::vector<RunRow>& runs, const std::string& scene,
                           const std::string& planner, int seed);

/// Chooses which of the recorded blocks are replayed: some planners' calls take a thousand times as long as
/// others', and all of them would fill a day. Returns the places of as many blocks as take a tenth of a
/// second together, but of four at least, spread evenly; all when they are quick enough.
std::vector<std::size_t> replayedBlocks(std::size_t blocks, std::size_t callsPerBlock, double secondsPerCall);

}  // namespace clearway::study
