// A run as a text (JSON), by which the process that did it tells it to the process that writes it down.
#pragma once

#include <string>
#include <vector>

#include "program/study/planner_run.h"
#include "program/study/planner_runs.h"

namespace clearway::study {

/// A run of a benchmark, with the warnings that came up.
struct ToldRun {
    BenchmarkRun run;  ///< without its measures, which its properties hold, and without recorded calls
    std::vector<std::string> warnings;
};

std::string textOf(const ToldRun& told);
std::string textOf(const StudyRun& run);

/// Reads what textOf wrote. Throws std::runtime_error, naming what the text is of, when it is no such text.
ToldRun readToldRun(const std::string& text, const std::string& of);
StudyRun readStudyRun(const std::string& text, const std::string& of);

}  // namespace clearway::study
