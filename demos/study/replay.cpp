#include "demos/study/replay.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>

#include "clearway/targets.h"
#include "demos/study/replayer.h"
#include "demos/study/statistics.h"

namespace clearway::study {
namespace {

constexpr double kMostSeconds = 0.1;  ///< for all replayed blocks of a sample together
constexpr std::size_t kLeastBlocks = 4;

/// The recorded blocks of one run that are replayed.
struct Sample {
    std::string planner;
    int seed = 1;
    std::vector<CallBlock> blocks;
    std::vector<std::size_t> places;  ///< positions of the blocks among the recorded ones
    std::string answersFile;
    Answers answers;       ///< answers of the first engine that was asked
    std::string answered;  ///< the name of that engine
};

struct BuiltEngine {
    Engine engine;
    std::unique_ptr<Scene> scene;
    std::unique_ptr<Replayer> replayer;
};

/// Switches to an instruction set. The destructor switches back to the best one.
class TargetInUse {
  public:
    explicit TargetInUse(const std::string& name) { useTarget(name); }
    ~TargetInUse() { useTarget("best"); }
    TargetInUse(const TargetInUse&) = delete;
    TargetInUse& operator=(const TargetInUse&) = delete;
};

std::string placeOf(const Sample& sample, std::size_t block, std::size_t call) {
    return fmt::format("call {} of block {} of {} seed {}", call + 1, sample.places[block] + 1,
                       sample.planner, sample.seed);
}

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
           const std::vector<RunRow>& runs, GrowingTable<ReplayRow>& table)
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
                    // Answers to another choice of blocks are not used, and are replaced later.
                    if (areAnswersTo(sample.blocks, sample.answers)) sample.answered = "an earlier engine";
                }
                samples_.push_back(std::move(sample));
            }
        }
    }

    /// Returns true when the table has all of the group's rows. Removes the rows of a group that is
    /// incomplete because the program ended.
    bool isDone(const EngineGroup& group) {
        const auto isOfGroup = [&](const ReplayRow& row) {
            return row.scene == problem_.name && std::find(group.begin(), group.end(), row) != group.end();
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
        const TargetInUse target(group.front().instructions);
        std::vector<ReplayRow> rows;
        for (Sample& sample : samples_) {
            if (!replay(sample, rows)) return false;
        }
        table_.append(rows);
        return true;
    }

  private:
    /// Builds the engines, unless the previous group had equal trees. Returns false when the study was
    /// stopped.
    bool prepare(const EngineGroup& group) {
        if (!built_.empty() && !built_.front().engine.sharesTreesWith(group.front())) built_.clear();
        if (!built_.empty()) {
            for (std::size_t i = 0; i < group.size(); ++i) built_[i].engine = group[i];
            return true;
        }
        for (const Engine& engine : group) {
            if (options_.mustStop()) return false;
            BuiltEngine made;
            made.engine = engine;
            made.scene = std::make_unique<Scene>(buildScene(problem_, engine, options_));
            made.replayer = std::make_unique<Replayer>(problem_.problem, *made.scene);
            built_.push_back(std::move(made));
        }
        return true;
    }

    /// Returns false when the study was stopped.
    bool replay(Sample& sample, std::vector<ReplayRow>& rows) {
        std::vector<std::vector<QueryTally>> tallies;
        for (BuiltEngine& each : built_) {
            if (options_.mustStop()) return false;
            ReplayedCalls replayed = each.replayer->replay(sample.blocks);
            compare(sample, replayed.answers, each.engine);
            tallies.push_back(std::move(replayed.tallies));
        }
        const std::vector<std::vector<double>> seconds = timeAll(sample);
        if (seconds.empty()) return false;
        for (std::size_t i = 0; i < built_.size(); ++i) {
            for (std::size_t block = 0; block < sample.blocks.size(); ++block) {
                ReplayRow row;
                static_cast<Engine&>(row) = built_[i].engine;
                static_cast<Work&>(row) = Work(tallies[i][block]);
                row.scene = problem_.name;
                row.planner = sample.planner;
                row.seed = sample.seed;
                row.block = sample.places[block];
                row.calls = sample.blocks[block].size();
                row.seconds = seconds[i][block];
                rows.push_back(row);
            }
        }
        return true;
    }

    /// Returns the seconds as [engine][block]; empty when the study was stopped.
    std::vector<std::vector<double>> timeAll(const Sample& sample) {
        const std::size_t engines = built_.size(), blocks = sample.blocks.size();
        std::vector<std::vector<std::vector<double>>> all(engines, std::vector<std::vector<double>>(blocks));
        for (int repetition = 0; repetition < options_.repetitions; ++repetition) {
            for (std::size_t turn = 0; turn < engines; ++turn) {
                if (options_.mustStop()) return {};
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
            sample.answered = engine.name();
            return;
        }
        for (std::size_t block = 0; block < answers.size(); ++block) {
            for (std::size_t call = 0; call < answers[block].size(); ++call) {
                const CallAnswer here = answers[block][call], there = sample.answers.at(block).at(call);
                if (here == there) continue;
                const std::string what =
                    fmt::format("{}: {} answers '{}', {} '{}'", placeOf(sample, block, call), sample.answered,
                                static_cast<char>(there), engine.name(), static_cast<char>(here));
                const bool isOpen = here == CallAnswer::kUndecided || there == CallAnswer::kUndecided;
                if (!isOpen) throw std::logic_error("strategies contradict each other: " + what);
                options_.report(problem_.name + ": a motion is undecided with one strategy only: " + what);
            }
        }
    }

    const StudyProblem& problem_;
    const StudyOptions& options_;
    GrowingTable<ReplayRow>& table_;
    std::vector<Sample> samples_;
    std::vector<BuiltEngine> built_;
};

}  // namespace

Columns<ReplayRow> replayColumns() {
    const Columns<ReplayRow> scene = {{"scene", &ReplayRow::scene}};
    const Columns<ReplayRow> rest = {{"planner", &ReplayRow::planner},
                                     {"seed", &ReplayRow::seed},
                                     {"block", &ReplayRow::block},
                                     {"calls", &ReplayRow::calls},
                                     {"seconds", &ReplayRow::seconds},
                                     {"distance_queries", &ReplayRow::distanceQueries},
                                     {"within_queries", &ReplayRow::withinQueries},
                                     {"volume_tests", &ReplayRow::volumeTests},
                                     {"triangle_tests", &ReplayRow::triangleTests},
                                     {"triangle_lanes", &ReplayRow::triangleLanes},
                                     {"kernel_pairs", &ReplayRow::kernelPairs},
                                     {"kernel_lanes", &ReplayRow::kernelLanes}};
    return scene + engineColumns<ReplayRow>() + rest;
}

bool replayCalls(const StudyProblem& problem, const StudyOptions& options, const std::string& folder,
                 const std::vector<RunRow>& runs, GrowingTable<ReplayRow>& replays) {
    Replay replay(problem, options, folder, runs, replays);
    std::vector<EngineGroup> groups;
    for (const EngineGroup& group : replayedGroups(options)) {
        if (!replay.isDone(group)) groups.push_back(group);
    }
    TimeLeft left(groups.size(), 0);
    for (const EngineGroup& group : groups) {
        if (options.mustStop()) return false;
        options.report(problem.name + ": replay " + std::to_string(left.done() + 1) + " of " +
                       std::to_string(left.all()) + ", " + group.front().name() + " and others" +
                       (left.done() > 0 ? ", " + left.text() + " for its replays" : ""));
        if (!replay.replay(group)) return false;
        left.step();
    }
    return true;
}

double querySecondsPerCall(const std::vector<RunRow>& runs, const std::string& scene,
                           const std::string& planner, int seed) {
    std::vector<double> all;
    for (const RunRow& run : runs) {
        if (run.scene != scene || run.planner != planner || run.seed != seed) continue;
        if (run.calls() > 0) all.push_back(run.querySeconds.value_or(0) / run.calls());
    }
    return all.empty() ? 0 : median(std::move(all));
}

std::vector<std::size_t> replayedBlocks(std::size_t blocks, std::size_t callsPerBlock,
                                        double secondsPerCall) {
    const double each = secondsPerCall * static_cast<double>(callsPerBlock);
    std::size_t count = blocks;
    if (each * static_cast<double>(blocks) > kMostSeconds)
        count = std::min(blocks, std::max(kLeastBlocks, static_cast<std::size_t>(kMostSeconds / each)));
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < count; ++i) places.push_back(i * blocks / count);
    return places;
}

}  // namespace clearway::study
