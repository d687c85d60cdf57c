// Prints a study's results as tables.
#pragma once

#include "demos/study/study.h"

namespace clearway::cli {

/// Prints tables for each scene to standard output: the planner runs, the ratios between strategies in runs
/// and in replays, the thesis's tables beside clearway's, and the verdicts on the thesis's claims.
void printStudy(const study::StudyResult& result);

}  // namespace clearway::cli
