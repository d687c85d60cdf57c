// Which of the recorded blocks of calls are replayed: some planners' calls take a thousand times as long as
// others', and all of them would fill a day.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "program/study/growing_table.h"

namespace clearway::study {

/// Seconds in queries for each call of a planner: of the runs with that seed the one in the middle. 0 when
/// there are none.
double querySecondsPerCall(const std::vector<TableRow>& runs, const std::string& scene,
                           const std::string& planner, int seed);

/// The places of those of so many blocks that take a tenth of a second together, but of four at least, spread
/// evenly; all when they are quick enough.
std::vector<std::size_t> replayedBlocks(std::size_t blocks, std::size_t callsPerBlock, double secondsPerCall);

}  // namespace clearway::study
