// The study's planner runs: every planner with every strategy and seed, each once.
#pragma once

#include <string>
#include <vector>

#include "program/study/experiment.h"
#include "program/study/planner_run.h"
#include "program/study/table.h"

namespace clearway::study {

/// Identifies the rows about calls of a planner: runs, and replays of their blocks.
struct CallsRow : Engine {
    std::string scene, planner;
    int seed = 1;
    std::uint64_t block = 0;  ///< of the recorded ones; 0 for runs
};

/// A row of runs.csv. Runs use the default trees and the best instructions.
struct RunRow : CallsRow, RunMeasures {
    /// How many states and motions the planner asked about.
    double calls() const;

    /// The processor's seconds; where they are missing, the clock's.
    Measure askingSeconds() const { return processorSeconds ? processorSeconds : seconds; }

    /// Empty unless the run found a path.
    Measure firstSolution() const;
    Measure finiteCost() const;

    /// True when the run had less than 95 % of a processor: the machine was at other work, which the run's
    /// times by the clock include.
    bool wasDisturbed() const;
};

/// scene, planner, general_split, leaf_split, seed; then the columns of runProperties().
Columns<RunRow> runColumns();

/// Does the runs that the table lacks, seed by seed, and appends each as it ends. For each planner and seed,
/// one run leaves a sample of its calls in the folder; the strategies take turns. Returns false when it was
/// stopped:
/// then the run at hand is not in the table. Reports warnings. Throws std::runtime_error when the table has a
/// run twice.
bool runPlanners(const StudyProblem& problem, const StudyOptions& options, const std::string& folder,
                 GrowingTable<RunRow>& runs);

/// The file of a run's sample.
std::string callsFile(const std::string& folder, const std::string& scene, const std::string& planner,
                      int seed);

/// Writes the problem's runs as OMPL's benchmark logs, FOLDER/logs/SCENE_GENERAL_LEAF.log: one experiment for
/// each strategy, with the strategy as its parameter, so that OMPL's statistics script and Planner Arena can
/// tell strategies apart.
void writeStudyLogs(const StudyProblem& problem, const StudyOptions& options, const std::vector<RunRow>& runs,
                    const std::string& folder);

/// The processor's name; "unknown" when the system does not tell.
std::string processorName();

}  // namespace clearway::study
