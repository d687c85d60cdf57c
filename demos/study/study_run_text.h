// A study's run as a line of JSON, as in run_text.h.
#pragma once

#include <string>

#include "demos/study/planner_runs.h"

namespace clearway::study {

std::string textOf(const StudyRun& run);

/// Throws a std::exception when textOf() wrote no such text.
StudyRun readStudyRun(const std::string& text);

}  // namespace clearway::study
