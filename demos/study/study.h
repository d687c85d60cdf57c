// The study of leaf splits: what the trees change for planners, from files to a path.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "demos/study/experiment.h"
#include "demos/study/workers.h"

namespace clearway::study {

/// Reads the study's problem of this position. Called in this process and in others.
using LoadProblem = std::function<StudyProblem(std::size_t position)>;

/// The part of the study that its worker processes do.
DoJob studyJobs(const LoadProblem& load, const StudyOptions& options, const std::string& folder);

struct StudyResult {
    bool isComplete = false;  ///< false when the study was stopped before its end
    std::string answer;       ///< two sentences
};

/// Measures, and computes how trees differ. The folder holds the results: settings.csv; files.csv, qualification.csv, qualified.csv,
///   runs.csv, trees.csv, replay.csv and calls/* as they grow; cells.csv, ratios.csv, claims.csv and answer.txt at the end.
/// In a folder that holds a part of a study, the study continues: rows that its tables hold are not measured
/// again. Throws std::invalid_argument, naming the setting and both values, when the folder's study has other
/// options, problems, processor or instructions. Throws std::runtime_error when a file cannot be written,
/// another program works on the folder's study, or a worker failed.
StudyResult studyLeafStrategies(std::size_t problems, const LoadProblem& load, const StudyOptions& options,
                                const std::string& folder, Workers& workers);

}  // namespace clearway::study
