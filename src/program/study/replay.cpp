#include "program/study/replay.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>

#include "clearway/targets.h"
#include "core/number.h"
#include "program/study/call_file.h"
#include "program/study/paired_ratio.h"
#include "program/study/planner_runs.h"
#include "program/study/replayed_blocks.h"
#include "program/study/replayer.h"
#include "program/study/time_left.h"

namespace clearway::study {
namespace {

using planning::QueryTally;

/// What one run of a planner recorded, or as much of it as is replayed.
struct Sample {
    std::string planner;
    int seed = 1;
    std::vector<CallBlock> blocks;
    std::vector<std::size_t> places;  ///< of the blocks, among those recorded
    std::string answersFile;
    Answers answers;       ///< of the first engine that was asked
    std::string answered;  ///< by this one
};

struct BuiltEngine {
    Engine engine;
    std::unique_ptr<Scene> scene;
    std::unique_ptr<Replayer> replayer;
};

/// Instructions of the engine's choice until it is gone.
class TargetInUse {
  public:
    explicit TargetInUse(const std::string& name) { useTarget(name); }
    ~TargetInUse() { useTarget("best"); }
    TargetInUse(const TargetInUse&) = delete;
    TargetInUse& operator=(const TargetInUse&) = delete;
};

std::string placeOf(const Sample& sample, std::size_t block, std::size_t call) {
    return "call " + std::to_string(call + 1) + " of block " + std::to_string(sample.places[block] + 1) +
           " of " + sample.planner + " seed " + std::to_string(sample.seed);
}

/// As much of a run's sample as is replayed.
void readBlocks(const std::string& file, std::size_t callsPerBlock, double secondsPerCall, Sample& sample) {
    const std::vector<CallBlock> all = readCalls(file);
    sample.places = replayedBlocks(all.size(), callsPerBlock, secondsPerCall);
    for (const std::size_t place : sample.places) sample.blocks.push_back(all[place]);
}

bool areAnswersTo(const std::vector<CallBlock>& blocks, const Answers& answers) {
    return std::equal(blocks.begin(), blocks.end(), answers.begin(), answers.end(),
                      [](const CallBlock& block, const auto& of) { return block.size() == of.size(); });
}

class Replay {
  public:
    Replay(const StudyProblem& problem, const StudyOptions& options, const std::string& folder,
           const std::vector<TableRow>& runs, GrowingTable& table)
        : problem_(problem), options_(options), table_(table) {
        for (const StudyPlanner& planner : options.planners) {
            for (int seed = 1; seed <= options.seeds; ++seed) {
                Sample sample;
                sample.planner = planner.name;
                sample.seed = seed;
                const std::string file = callsFile(folder, problem.name, planner.name, seed);
                readBlocks(file, options.sampling.callsPerBlock,
                           querySecondsPerCall(runs, problem.name, planner.name, seed), sample);
                sample.answersFile = answersFile(file);
                if (std::filesystem::exists(sample.answersFile)) {
                    sample.answers = readAnswers(sample.answersFile);
                    // else they are those of another choice of blocks, and written anew
                    if (areAnswersTo(sample.blocks, sample.answers)) sample.answered = "an earlier engine";
                }
                samples_.push_back(std::move(sample));
            }
        }
    }

    /// True when the table has all of the group's rows. Fewer, which the program's end cut short, are taken
    /// away.
    bool isDone(const EngineGroup& group) {
        std::vector<TableRow> keys;
        for (const Engine& engine : group) {
            keys.push_back(engineRow(engine));
            keys.back()["scene"] = problem_.name;
        }
        const auto isOfGroup = [&](const TableRow& row) {
            return std::any_of(keys.begin(), keys.end(), [&](const TableRow& key) {
                return std::all_of(key.begin(), key.end(),
                                   [&](const auto& wanted) { return row.at(wanted.first) == wanted.second; });
            });
        };
        const auto there =
            static_cast<std::size_t>(std::count_if(table_.rows().begin(), table_.rows().end(), isOfGroup));
        std::size_t blocks = 0;
        for (const Sample& sample : samples_) blocks += sample.blocks.size();
        if (there >= blocks * group.size()) return true;
        if (there > 0) table_.remove(isOfGroup);
        return false;
    }

    bool replay(const EngineGroup& group) {
        if (!prepare(group)) return false;
        const TargetInUse target(group.front().target);
        std::vector<TableRow> rows;
        for (Sample& sample : samples_) {
            if (!replay(sample, rows)) return false;
        }
        table_.append(rows);
        return true;
    }

    /// So that no more trees are kept than the next group needs.
    void forget(const EngineGroup& next) {
        if (!built_.empty() && !shareTrees(built_.front().engine, next.front())) built_.clear();
    }

  private:
    bool isStopped() const { return options_.isStopped && options_.isStopped(); }

    /// False when it was stopped.
    bool prepare(const EngineGroup& group) {
        forget(group);
        if (!built_.empty()) {
            for (std::size_t i = 0; i < group.size(); ++i) built_[i].engine = group[i];
            return true;
        }
        for (const Engine& engine : group) {
            if (isStopped()) return false;
            BuiltEngine made;
            made.engine = engine;
            made.scene = std::make_unique<Scene>(buildScene(problem_, engine, options_.cache));
            made.replayer = std::make_unique<Replayer>(problem_.problem, *made.scene);
            built_.push_back(std::move(made));
        }
        return true;
    }

    /// False when it was stopped.
    bool replay(Sample& sample, std::vector<TableRow>& rows) {
        std::vector<std::vector<QueryTally>> tallies;
        for (BuiltEngine& each : built_) {
            if (isStopped()) return false;
            ReplayedCalls replayed = each.replayer->replay(sample.blocks);
            compare(sample, replayed.answers, each.engine);
            tallies.push_back(std::move(replayed.tallies));
        }
        const std::vector<std::vector<double>> seconds = timeAll(sample);
        if (seconds.empty()) return false;
        for (std::size_t i = 0; i < built_.size(); ++i) {
            for (std::size_t block = 0; block < sample.blocks.size(); ++block) {
                rows.push_back(rowOf(sample, built_[i].engine, block, seconds[i][block], tallies[i][block]));
            }
        }
        return true;
    }

    /// [engine][block]. Empty when it was stopped.
    std::vector<std::vector<double>> timeAll(const Sample& sample) {
        const std::size_t engines = built_.size(), blocks = sample.blocks.size();
        std::vector<std::vector<std::vector<double>>> all(engines, std::vector<std::vector<double>>(blocks));
        for (int repetition = 0; repetition < options_.repetitions; ++repetition) {
            for (std::size_t turn = 0; turn < engines; ++turn) {
                if (isStopped()) return {};
                const std::size_t i = (turn + static_cast<std::size_t>(repetition)) % engines;
                const std::vector<double> seconds = built_[i].replayer->time(sample.blocks);
                for (std::size_t block = 0; block < blocks; ++block) all[i][block].push_back(seconds[block]);
            }
        }
        std::vector<std::vector<double>> medians(engines);
        for (std::size_t i = 0; i < engines; ++i) {
            for (auto& of : all[i]) medians[i].push_back(median(std::move(of)));
        }
        return medians;
    }

    void compare(Sample& sample, const Answers& answers, const Engine& engine) {
        if (sample.answered.empty()) {
            writeAnswers(answers, sample.answersFile);
            sample.answers = answers;
            sample.answered = nameOf(engine);
            return;
        }
        for (std::size_t block = 0; block < answers.size(); ++block) {
            for (std::size_t call = 0; call < answers[block].size(); ++call) {
                const CallAnswer here = answers[block][call], there = sample.answers.at(block).at(call);
                if (here == there) continue;
                const std::string what = placeOf(sample, block, call) + ": " + sample.answered +
                                         " answers '" + static_cast<char>(there) + "', " + nameOf(engine) +
                                         " '" + static_cast<char>(here) + "'";
                const bool isOpen = here == CallAnswer::kUndecided || there == CallAnswer::kUndecided;
                if (!isOpen) throw std::logic_error("strategies contradict each other: " + what);
                if (options_.tell)
                    options_.tell(problem_.name +
                                  ": a motion that is undecided with one strategy only: " + what);
            }
        }
    }

    TableRow rowOf(const Sample& sample, const Engine& engine, std::size_t block, double seconds,
                   const QueryTally& tally) const {
        TableRow row = engineRow(engine);
        const auto put = [&](const char* name, std::uint64_t count) { row[name] = std::to_string(count); };
        row["scene"] = problem_.name;
        row["planner"] = sample.planner;
        row["seed"] = std::to_string(sample.seed);
        put("block", sample.places[block]);
        put("calls", sample.blocks[block].size());
        row["seconds"] = shortNumber(seconds);
        put("distance_queries", tally.distances);
        put("within_queries", tally.withins);
        put("volume_tests", tally.work.volumeTests);
        put("triangle_tests", tally.work.triangleTests);
        put("triangle_lanes", tally.work.triangleLanes);
        put("kernel_pairs", tally.work.kernelPairs);
        put("kernel_lanes", tally.work.kernelLanes);
        return row;
    }

    const StudyProblem& problem_;
    const StudyOptions& options_;
    GrowingTable& table_;
    std::vector<Sample> samples_;
    std::vector<BuiltEngine> built_;
};

}  // namespace

std::vector<std::string> replayColumns() {
    std::vector<std::string> columns = {"scene"};
    for (const std::string& column : engineColumns()) columns.push_back(column);
    for (const char* column :
         {"planner", "seed", "block", "calls", "seconds", "distance_queries", "within_queries",
          "volume_tests", "triangle_tests", "triangle_lanes", "kernel_pairs", "kernel_lanes"}) {
        columns.push_back(column);
    }
    return columns;
}

bool replayCalls(const StudyProblem& problem, const StudyOptions& options, const std::string& folder,
                 const std::vector<TableRow>& runs, GrowingTable& replays) {
    Replay replay(problem, options, folder, runs, replays);
    std::vector<EngineGroup> groups;
    for (const EngineGroup& group : replayedGroups(options)) {
        if (!replay.isDone(group)) groups.push_back(group);
    }
    TimeLeft left(groups.size(), 0);
    for (const EngineGroup& group : groups) {
        if (options.isStopped && options.isStopped()) return false;
        if (options.tell) {
            options.tell(problem.name + ": replay " + std::to_string(left.done() + 1) + " of " +
                         std::to_string(left.all()) + ", " + nameOf(group.front()) + " and others" +
                         (left.done() > 0 ? ", " + left.text() + " for its replays" : ""));
        }
        if (!replay.replay(group)) return false;
        left.step();
    }
    return true;
}

}  // namespace clearway::study
