// A study's results as tables to read.
#pragma once

#include "program/study/study.h"

namespace clearway::cli {

/// To standard output: of each scene the planner runs, what strategies change with their runs and by replay,
/// the thesis's tables beside ours, and the verdicts on its claims.
void printStudy(const study::StudyResult& result);

}  // namespace clearway::cli
