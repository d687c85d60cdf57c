// A study's results as tables to read.
#pragma once

#include "study/study.h"

namespace clearway {

/// To standard output: of each scene the planner runs, what strategies change with their runs and by replay,
/// the thesis's tables beside ours, and the verdicts on its claims.
void printStudy(const StudyResult& result);

}  // namespace clearway
