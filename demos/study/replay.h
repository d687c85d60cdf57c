// Measures the effect of strategies alone: replays the recorded calls of planner runs with every engine.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "demos/study/experiment.h"
#include "demos/study/planner_runs.h"
#include "program/bench/table.h"

namespace clearway::study {

/// A row of replay.csv: the work of one block of calls.
struct ReplayRow : CallsRow, Work {
    std::uint64_t calls = 0;
    double seconds = 0;  ///< processor time
};

/// scene and engineColumns(); planner, seed, block; calls, seconds and work of the block.
Columns<ReplayRow> replayColumns();

/// Replays the folder's samples with the groups of engines that the table lacks, one group at a time. Samples
/// of slow planners are replayed in part (see replayedBlocks). Within a group the engines take turns, sample
/// by sample, and each block's time is the median of the repetitions. runs: all rows of the planners' runs.
/// Returns false when the study was stopped: then the current group is not in the table.
///
/// All engines must give one answer to a call. A motion that only one engine leaves undecided is no
/// contradiction, and is reported. Throws std::logic_error that names engines and call when one engine says
/// yes and another no.
bool replayCalls(const StudyProblem& problem, const StudyOptions& options, const std::string& folder,
                 const std::vector<RunRow>& runs, GrowingTable<ReplayRow>& replays);

/// The seconds of a planner's call: the median of the runs with that seed. 0 without runs.
double querySecondsPerCall(const std::vector<RunRow>& runs, const std::string& scene,
                           const std::string& planner, int seed);

/// Chooses the recorded blocks to replay. Some planners' calls take a thousand times as long as others', and
/// all of them would take a day. Returns the positions of as many blocks as take a tenth of a second
/// together, but of four at least, spread evenly. Returns all positions if all blocks together are that
/// quick.
std::vector<std::size_t> replayedBlocks(std::size_t blocks, std::size_t callsPerBlock, double secondsPerCall);

}  // namespace clearway::study
