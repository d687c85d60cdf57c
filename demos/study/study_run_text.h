// A study's run as a text, like those of run_text.h.
#pragma once

#include <string>

#include "demos/study/planner_runs.h"

namespace clearway::study {

std::string textOf(const StudyRun& run);

/// Throws as readToldRun() does.
StudyRun readStudyRun(const std::string& text, const std::string& of);

}  // namespace clearway::study
