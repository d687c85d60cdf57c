// The leaf-strategy study: how the way of splitting leaves changes what planners need.
#pragma once

#include <string>
#include <vector>

#include "program/study/claims.h"
#include "program/study/experiment.h"
#include "program/study/statistics.h"
#include "program/study/tree_tables.h"

namespace clearway::study {

struct StudyResult {
    bool isComplete = false;  ///< not stopped before its end; otherwise the tables are empty
    std::vector<StatisticRow> statistics;
    std::vector<SummaryRow> summary;
    std::vector<TreeRow> trees;
    std::vector<ClaimRow> claims;
};

/// Runs planners, replays their calls and works out what the strategies change. The folder holds all of it:
///   settings.csv, runs.csv, replay.csv, trees.csv and calls/* as they grow; statistics.csv, summary.csv,
///   claims.csv and logs/*.log at the end.
/// In a folder that holds part of a study, the study goes on: nothing in its tables is done again. Throws
/// std::invalid_argument when the folder's study has other options, problems, processor or instructions,
/// naming the setting and both values; std::runtime_error when a file cannot be written, or another program
/// is at the folder's study.
StudyResult studyLeafStrategies(const std::vector<StudyProblem>& problems, const StudyOptions& options,
                                const std::string& folder);

}  // namespace clearway::study
