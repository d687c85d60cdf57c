// The leaf-strategy study: what splitting leaves one way or another changes for planners.
#pragma once

#include <string>
#include <vector>

#include "program/study/growing_table.h"
#include "program/study/study_options.h"
#include "program/study/study_problem.h"

namespace clearway::study {

struct StudyResult {
    bool isComplete = false;           ///< not stopped before its end; else the next lines are empty
    std::vector<TableRow> statistics;  ///< see statistics.h
    std::vector<TableRow> summary;
    std::vector<TableRow> trees;   ///< see tree_tables.h
    std::vector<TableRow> claims;  ///< see claims.h
};

/// Runs planners, replays their calls and works out what the strategies change, in a folder that holds all of
/// it:
///   settings.csv, runs.csv, replay.csv, trees.csv and calls/* as they grow; statistics.csv, summary.csv,
///   claims.csv and logs/*.log at the end.
/// A folder that holds part of a study is gone on with: what is in its tables is not done again. Throws
/// std::invalid_argument when the folder's study has other options, problems, processor or instructions,
/// naming the setting and both values; std::runtime_error when a file cannot be written, or another program
/// is at the folder's study.
StudyResult studyLeafStrategies(const std::vector<StudyProblem>& problems, const StudyOptions& options,
                                const std::string& folder);

}  // namespace clearway::study
