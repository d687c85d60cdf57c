// The study's planner runs: every planner with every strategy and seed, each once.
#pragma once

#include <string>
#include <vector>

#include "program/study/benchmark.h"
#include "program/study/growing_table.h"
#include "program/study/study_options.h"
#include "program/study/study_problem.h"

namespace clearway::study {

/// scene, planner, general_split, leaf_split, seed; then what runs are measured by.
std::vector<std::string> runColumns();

/// Of runs the properties that OMPL's logs have, by OMPL's names.
Properties propertiesOf(const TableRow& run);

/// Does the runs that the table lacks, seed by seed, and appends each as it ends. One run of each planner and
/// seed leaves a sample of its calls in the folder, the strategies taking turns. False when it was stopped:
/// then the run at hand is not in the table. Warnings are told. Throws
/// std::runtime_error when the table has a run twice.
bool runPlanners(const StudyProblem& problem, const StudyOptions& options, const std::string& folder,
                 GrowingTable& runs);

/// The file of a run's sample.
std::string callsFile(const std::string& folder, const std::string& scene, const std::string& planner,
                      int seed);

}  // namespace clearway::study
