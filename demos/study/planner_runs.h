// The study's planner runs: every planner with every strategy and seed, each once.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "demos/study/experiment.h"
#include "program/bench/planner_run.h"
#include "program/bench/table.h"

namespace clearway::study {

/// Identifies a row about calls of a planner: a run, or the replay of a block of a run.
struct CallsRow : Engine {
    std::string scene, planner;
    int seed = 1;
    std::uint64_t block = 0;  ///< position among the recorded blocks; 0 for runs
};

/// A row of runs.csv. Runs use the default trees and the best instructions.
struct RunRow : CallsRow, RunMeasures {
    /// The number of states and motions that the planner asked about.
    double calls() const;

    /// The run's processor seconds, or its clock seconds where processor seconds are missing.
    Measure askingSeconds() const { return processorSeconds ? processorSeconds : seconds; }

    /// Empty unless the run found a path.
    Measure firstSolution() const;
    Measure finiteCost() const;

    /// True when the run had less than 95 % of a processor. The machine was then busy with other work, and
    /// the run's clock times include it.
    bool wasDisturbed() const;
};

/// scene, planner, general_split, leaf_split, seed; then the columns of runProperties().
Columns<RunRow> runColumns();

struct PlannedRun {
    StudyPlanner planner;
    Engine engine;
    std::size_t strategy = 0;  ///< position among all engines
    int seed = 1;
    bool keepsCalls = false;  ///< this run leaves the sample of its planner's and seed's calls

    std::string name() const;  ///< "RRTConnect sah/none seed 1"
};

/// A problem's runs in their order. A study's runs are numbered from 0 over all its problems.
std::vector<PlannedRun> plannedRuns(const StudyOptions& options);

/// A run that has ended.
struct StudyRun {
    RunRow row;
    std::optional<std::string> calls;  ///< the text of its sample, if it leaves one
    std::string machine;               ///< the processor and the instructions in use
    std::vector<std::string> warnings;
};

/// Does one run in a scene of the run's engine. Returns nothing when the study was stopped.
std::optional<StudyRun> runPlanned(const StudyProblem& problem, const Scene& scene,
                                   const StudyOptions& options, const PlannedRun& planned);

/// The numbers of the runs that the table lacks, for the study's problem at this position.
std::vector<std::size_t> missingRuns(const StudyProblem& problem, std::size_t position,
                                     const StudyOptions& options, const GrowingTable<RunRow>& runs);

/// Writes the run's sample and then its row, so that every run in the table has its sample, and reports its warnings. Throws
/// std::runtime_error when another machine did the run.
void keepRun(const StudyRun& run, const StudyOptions& options, const std::string& folder,
             GrowingTable<RunRow>& runs);

/// Does the runs that the table lacks, seed by seed, and appends each as it ends. For each planner and seed,
/// one run leaves a sample of its calls in the folder; the strategies take turns. Reports warnings. Returns
/// false when the study was stopped: then the current run is not in the table. Throws std::runtime_error when
/// the table has a run twice.
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

/// The processor and the instructions in use.
std::string machineName();

/// The processor's name; "unknown" if the system does not say.
std::string processorName();

}  // namespace clearway::study
