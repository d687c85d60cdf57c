// Replays recorded calls of planner runs in trees of every kind: the effect of the trees alone.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "demos/study/calls.h"
#include "demos/study/experiment.h"
#include "demos/study/planner_runs.h"
#include "demos/study/table.h"

namespace clearway::study {

/// A row of replay.csv: the work of one sample of calls.
struct ReplayRow : CallsRow, Work {
    std::uint64_t calls = 0;
    double seconds = 0;  ///< processor time
};

/// scene and engineColumns(); planner, seed; calls, seconds and work of the sample.
Columns<ReplayRow> replayColumns();

/// Calls of one run, and the qualifying engine's answers.
struct CallsSample {
    std::string planner;
    int seed = 1;
    std::vector<CallBlock> blocks;
    Answers answers;
};

/// The file of a run's sample.
std::string callsFile(const std::string& folder, const std::string& scene, const std::string& planner,
                      int seed);

/// Keeps a run's sample in its file, and the answers that the scene's trees give in another. Keeps as many blocks as are asked in
/// kMostReplaySeconds, but at least kLeastReplayedBlocks, spread evenly over the run.
void keepCalls(const StudyRun& run, const StudyProblem& problem, const Scene& scene,
               const std::string& folder);
constexpr double kMostReplaySeconds = 0.02;
constexpr std::size_t kLeastReplayedBlocks = 4;

bool hasSample(const std::string& folder, const std::string& scene, const std::string& planner, int seed);

/// Reads a sample. Returns nothing when there is none.
std::optional<CallsSample> readSample(const std::string& folder, const std::string& scene,
                                      const std::string& planner, int seed);

/// Replays the samples with the engines of a group. The engines take turns, sample by sample, and the median of the repetitions
/// counts. Returns nothing when the study was stopped.
///
/// All engines must give the answers of the sample. A motion that only one engine leaves undecided is no contradiction, and is told.
/// Throws std::logic_error that names engine and call when an engine says yes where the sample says no, or the other way round.
std::optional<std::vector<ReplayRow>> replayGroup(const StudyProblem& problem, const EngineGroup& group,
                                                  const std::vector<CallsSample>& samples,
                                                  const StudyOptions& options);

/// The positions of `count` of `all` blocks, spread evenly.
std::vector<std::size_t> spreadEvenly(std::size_t count, std::size_t all);

}  // namespace clearway::study
