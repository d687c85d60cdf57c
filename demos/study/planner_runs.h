// The study's planner runs: from a seed to the first path.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "demos/study/calls.h"
#include "demos/study/experiment.h"
#include "demos/study/table.h"
#include "program/bench/planner_run.h"

namespace clearway::study {

/// Identifies a row about calls of a planner: a run, or the replay of a sample of its calls.
struct CallsRow : Engine {
    std::string scene, planner;
    int seed = 1;
};

/// A row of qualification.csv and runs.csv. Runs use the default leaf size, width and instructions.
struct RunRow : CallsRow, RunMeasures {
    /// The number of states and motions that the planner asked about. Empty for a planner that asks from threads of its own, or asks
    /// the scene itself: then the recorded calls are not all.
    Measure calls() const;

    /// The seconds to the first path; empty unless the run found one.
    Measure planningSeconds() const { return isSolved == 1u ? firstSolutionSeconds : std::nullopt; }

    /// True when the run had less than 95 % of a processor. The machine was then busy with other work, and
    /// the run's clock times include it.
    bool wasDisturbed() const;
};

/// scene, planner, general_split, leaf_split, seed; then the columns of runProperties().
Columns<RunRow> runColumns();

struct PlannedRun {
    std::string planner;  ///< its class
    Engine engine;
    int seed = 1;
    double seconds = 10;  ///< its limit

    std::string name() const;  ///< "RRTConnect sah/none seed 1"
};

/// A run that has ended.
struct StudyRun {
    RunRow row;
    std::vector<CallBlock> calls;  ///< the sample; empty unless it was asked for
    std::vector<std::string> warnings;
};

/// Does one run in a scene of the run's engine, up to its first path. samplesCalls: recording takes a little time. Returns nothing
/// when the study was stopped.
std::optional<StudyRun> runPlanned(const StudyProblem& problem, const Scene& scene,
                                   const StudyOptions& options, const PlannedRun& planned, bool samplesCalls);

/// The processor's name; "unknown" if the system does not say.
std::string processorName();

}  // namespace clearway::study
