// The leaf-strategy study: measures how leaf splits change the work of planners.
#pragma once

#include <string>
#include <vector>

#include "demos/study/claims.h"
#include "demos/study/experiment.h"
#include "demos/study/statistics.h"
#include "demos/study/tree_tables.h"

namespace clearway::study {

struct StudyResult {
    bool isComplete = false;  ///< false when the study was stopped before its end; the tables are then empty
    std::vector<StatisticRow> statistics;
    std::vector<SummaryRow> summary;
    std::vector<TreeRow> trees;
    std::vector<ClaimRow> claims;
};

/// Runs planners, replays their calls and computes how the strategies differ. The folder holds the results:
///   settings.csv, runs.csv, replay.csv, trees.csv and calls/* as they grow; statistics.csv, summary.csv,
///   claims.csv and logs/*.log at the end.
/// In a folder that holds a part of a study, the study continues: rows that its tables hold are not measured
/// again. Throws std::invalid_argument, naming the setting and both values, when the folder's study has other
/// options, problems, processor or instructions. Throws std::runtime_error when a file cannot be written, or
/// another program works on the folder's study.
StudyResult studyLeafStrategies(const std::vector<StudyProblem>& problems, const StudyOptions& options,
                                const std::string& folder);

}  // namespace clearway::study
