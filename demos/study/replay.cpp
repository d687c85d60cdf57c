#include "demos/study/replay.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <numeric>
#include <stdexcept>

#include "clearway/targets.h"
#include "demos/study/replayer.h"
#include "demos/study/statistics.h"

namespace clearway::study {
namespace {

struct BuiltEngine {
    Engine engine;
    std::shared_ptr<Replayer> replayer;
};

/// Restores the best instruction set in the end.
struct OtherTargets {
    OtherTargets() = default;
    ~OtherTargets() { useTarget("best"); }
    OtherTargets(const OtherTargets&) = delete;
    OtherTargets& operator=(const OtherTargets&) = delete;
};

void compare(const StudyProblem& problem, const CallsSample& sample, const Answers& answers,
             const Engine& engine, const StudyOptions& options) {
    for (std::size_t block = 0; block < answers.size(); ++block) {
        for (std::size_t call = 0; call < answers[block].size(); ++call) {
            const CallAnswer here = answers[block][call], there = sample.answers.at(block).at(call);
            if (here == there) continue;
            const std::string what = fmt::format(
                "{}: call {} of block {} of {} seed {}: {} answers '{}', {} '{}'", problem.name, call + 1,
                block + 1, sample.planner, sample.seed, qualifyingEngine(options).name(),
                static_cast<char>(there), engine.name(), static_cast<char>(here));
            const bool isOpen = here == CallAnswer::kUndecided || there == CallAnswer::kUndecided;
            if (!isOpen) throw std::logic_error("trees contradict each other: " + what);
            options.report("a motion is undecided in one tree only: " + what);
        }
    }
}

/// The median over the repetitions of each engine's seconds; empty when the study was stopped.
std::vector<double> timeAll(std::vector<BuiltEngine>& built, const CallsSample& sample,
                            const StudyOptions& options) {
    const std::size_t engines = built.size();
    std::vector<std::vector<double>> all(engines);
    for (int repetition = 0; repetition < options.repetitions; ++repetition) {
        for (std::size_t turn = 0; turn < engines; ++turn) {
            if (options.mustStop()) return {};
            const std::size_t i = (turn + static_cast<std::size_t>(repetition)) % engines;
            useTarget(built[i].engine.instructions);
            const std::vector<double> seconds = built[i].replayer->time(sample.blocks);
            all[i].push_back(std::accumulate(seconds.begin(), seconds.end(), 0.0));
        }
    }
    std::vector<double> medians;
    for (std::vector<double>& each : all) medians.push_back(median(std::move(each)));
    return medians;
}

bool replaySample(const StudyProblem& problem, const CallsSample& sample, std::vector<BuiltEngine>& built,
                  const StudyOptions& options, std::vector<ReplayRow>& rows) {
    std::vector<ReplayRow> found;
    for (BuiltEngine& each : built) {
        if (options.mustStop()) return false;
        useTarget(each.engine.instructions);
        const ReplayedCalls replayed = each.replayer->replay(sample.blocks);
        compare(problem, sample, replayed.answers, each.engine, options);
        QueryTally tally;
        for (const QueryTally& block : replayed.tallies) {
            tally.distances += block.distances;
            tally.withins += block.withins;
            tally.sweeps += block.sweeps;
            tally.work += block.work;
        }
        ReplayRow row;
        static_cast<Engine&>(row) = each.engine;
        static_cast<Work&>(row) = Work(tally);
        row.scene = problem.name;
        row.planner = sample.planner;
        row.seed = sample.seed;
        for (const CallBlock& block : sample.blocks) row.calls += block.size();
        found.push_back(row);
    }
    const std::vector<double> seconds = timeAll(built, sample, options);
    if (seconds.empty()) return false;
    for (std::size_t i = 0; i < built.size(); ++i) {
        found[i].seconds = seconds[i];
        rows.push_back(found[i]);
    }
    return true;
}

}  // namespace

Columns<ReplayRow> replayColumns() {
    const Columns<ReplayRow> scene = {{"scene", &ReplayRow::scene}};
    const Columns<ReplayRow> rest = {{"planner", &ReplayRow::planner},
                                     {"seed", &ReplayRow::seed},
                                     {"calls", &ReplayRow::calls},
                                     {"seconds", &ReplayRow::seconds},
                                     {"distance_queries", &ReplayRow::distanceQueries},
                                     {"within_queries", &ReplayRow::withinQueries},
                                     {"sweep_queries", &ReplayRow::sweepQueries},
                                     {"volume_tests", &ReplayRow::volumeTests},
                                     {"triangle_tests", &ReplayRow::triangleTests},
                                     {"triangle_lanes", &ReplayRow::triangleLanes},
                                     {"kernel_pairs", &ReplayRow::kernelPairs},
                                     {"kernel_lanes", &ReplayRow::kernelLanes}};
    return scene + engineColumns<ReplayRow>() + rest;
}

std::string callsFile(const std::string& folder, const std::string& scene, const std::string& planner,
                      int seed) {
    return fmt::format("{}/calls/{}_{}_{}.calls", folder, scene, planner, seed);
}

void keepCalls(const StudyRun& run, const StudyProblem& problem, const Scene& scene,
               const std::string& folder) {
    Replayer replayer(problem.problem, scene);
    const std::vector<double> seconds = replayer.time(run.calls);
    const double all = std::accumulate(seconds.begin(), seconds.end(), 0.0);
    const auto count = static_cast<std::size_t>(static_cast<double>(run.calls.size()) *
                                                std::min(1.0, kMostReplaySeconds / std::max(all, 1e-9)));
    std::vector<CallBlock> kept;
    for (const std::size_t place : spreadEvenly(std::max(count, kLeastReplayedBlocks), run.calls.size()))
        kept.push_back(run.calls[place]);
    const std::string file = callsFile(folder, problem.name, run.row.planner, run.row.seed);
    writeCalls(callsText(kept), file);
    writeAnswers(replayer.replay(kept).answers, answersFile(file));
}

bool hasSample(const std::string& folder, const std::string& scene, const std::string& planner, int seed) {
    return std::filesystem::exists(answersFile(callsFile(folder, scene, planner, seed)));
}

std::optional<CallsSample> readSample(const std::string& folder, const std::string& scene,
                                      const std::string& planner, int seed) {
    if (!hasSample(folder, scene, planner, seed)) return std::nullopt;
    const std::string file = callsFile(folder, scene, planner, seed);
    return CallsSample{planner, seed, readCalls(file), readAnswers(answersFile(file))};
}

std::optional<std::vector<ReplayRow>> replayGroup(const StudyProblem& problem, const EngineGroup& group,
                                                  const std::vector<CallsSample>& samples,
                                                  const StudyOptions& options) {
    std::vector<std::unique_ptr<Scene>> scenes;
    std::vector<BuiltEngine> built;
    for (const Engine& engine : group) {
        if (options.mustStop()) return std::nullopt;
        const auto like = std::find_if(built.begin(), built.end(), [&](const BuiltEngine& other) {
            return other.engine.sharesTreesWith(engine);
        });
        if (like != built.end()) {
            const std::shared_ptr<Replayer> replayer = like->replayer;
            built.push_back({engine, replayer});
            continue;
        }
        scenes.push_back(std::make_unique<Scene>(buildScene(problem, engine)));
        built.push_back({engine, std::make_shared<Replayer>(problem.problem, *scenes.back())});
    }
    const OtherTargets targets;
    std::vector<ReplayRow> rows;
    for (const CallsSample& sample : samples) {
        if (!replaySample(problem, sample, built, options, rows)) return std::nullopt;
    }
    return rows;
}

std::vector<std::size_t> spreadEvenly(std::size_t count, std::size_t all) {
    count = std::min(count, all);
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < count; ++i) places.push_back(i * all / count);
    return places;
}

}  // namespace clearway::study
