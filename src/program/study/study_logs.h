// The study's runs as OMPL's benchmark logs: one experiment for each strategy, which is its parameter, so
// that OMPL's statistics script and Planner Arena can tell them apart and draw over them.
#pragma once

#include <string>
#include <vector>

#include "program/study/growing_table.h"
#include "program/study/study_options.h"
#include "program/study/study_problem.h"

namespace clearway::study {

/// FOLDER/logs/SCENE_GENERAL_LEAF.log for each of the problem's strategies. returns the files.
std::vector<std::string> writeStudyLogs(const StudyProblem& problem, const StudyOptions& options,
                                        const std::vector<TableRow>& runs, const std::string& folder);

}  // namespace clearway::study
