#include "demos/study/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <tuple>

#include "clearway/targets.h"
#include "core/clock.h"
#include "core/hash.h"
#include "core/number.h"
#include "core/replace_file.h"
#include "core/text.h"
#include "demos/study/answer.h"
#include "demos/study/claims.h"
#include "demos/study/qualification.h"
#include "demos/study/statistics.h"
#include "demos/study/tree_tables.h"

namespace clearway::study {
namespace {

constexpr double kSecondsBetweenRemarks = 20;  ///< about progress

/// A setting that results were begun with, kept with them: results of different settings are never mixed.
struct Setting {
    std::string name, value;
};
using Settings = std::vector<Setting>;

constexpr const char* kAsItWasBegun = "another folder or the options that it was begun with";

std::string hashOf(const std::string& text) {
    Hash hash;
    hash.add(text);
    return std::to_string(hash.value());
}

Settings settingsOf(const std::vector<StudyProblem>& problems, const StudyOptions& options) {
    const CallSampling& sampling = options.sampling;
    Settings settings = {
        {"planners", joined(options.planners, " ")},
        {"seeds", std::to_string(options.seeds)},
        {"minutes", shortNumber(options.minutes)},
        {"qualifying", fmt::format("{} s, median at most {} s", shortNumber(options.qualifyingSeconds),
                                   shortNumber(options.mostMedian))},
        {"sampled blocks", fmt::format("{} of {}", sampling.blocks, sampling.callsPerBlock)},
        {"repetitions", std::to_string(options.repetitions)},
        {"short", options.isShort ? "yes" : "no"},
        {"processor", processorName()},
        {"instructions", availableTargets().front()},
    };
    std::vector<std::string> names;
    for (const StudyProblem& problem : problems) names.push_back(problem.name);
    settings.push_back({"scenes", joined(names, " ")});
    for (const StudyProblem& problem : problems)
        settings.push_back({"scene " + problem.name, hashOf(problem.fingerprint())});
    return settings;
}

/// Keeps the settings in FOLDER/settings.csv, where none are kept. Commas in values become spaces. Otherwise compares them
/// with the kept ones and throws std::invalid_argument, which names the setting and both values.
void requireSettings(Settings settings, const std::string& folder) {
    for (auto& [name, value] : settings) {
        for (char& c : value) {
            if (c == ',' || c == '\n' || c == '\r') c = ' ';
        }
    }
    GrowingTable<Setting> kept(folder + "/settings.csv",
                               {{"setting", &Setting::name}, {"value", &Setting::value}});
    if (kept.rows().empty()) {
        kept.append(settings);
        return;
    }
    for (std::size_t i = 0; i < settings.size(); ++i) {
        const auto& [name, value] = settings[i];
        const bool isThere = i < kept.rows().size() && kept.rows()[i].name == name;
        const std::string before = isThere ? kept.rows()[i].value : "not there";
        if (before == value) continue;
        throw std::invalid_argument(fmt::format("the study in '{}' has {} '{}', not '{}', expected {}",
                                                folder, name, before, value, kAsItWasBegun));
    }
    if (kept.rows().size() > settings.size())
        throw std::invalid_argument(
            fmt::format("the study in '{}' has more settings, the last '{}', expected {}", folder,
                        kept.rows().back().name, kAsItWasBegun));
}

void requireDifferentNames(const std::vector<StudyProblem>& problems) {
    std::set<std::string> names;
    for (const StudyProblem& problem : problems) {
        if (names.insert(problem.name).second) continue;
        throw std::invalid_argument("two problems are named '" + problem.name +
                                    "', expected different names");
    }
}

auto keyOf(const RunRow& row) {
    return std::tie(row.scene, row.planner, row.generalSplit, row.leafSplit, row.seed);
}

/// Throws when the table has a run twice, because the run would count twice. Two programs at once may have written it, or a user's edit.
void requireOnce(const GrowingTable<RunRow>& runs) {
    std::set<std::tuple<std::string, std::string, std::string, std::string, int>> seen;
    for (const RunRow& row : runs.rows()) {
        if (seen.insert(keyOf(row)).second) continue;
        throw std::runtime_error(fmt::format("{} has the run of {} {} seed {} in {} twice, expected once",
                                             runs.file(), row.planner, row.name(), row.seed, row.scene));
    }
}

class Study {
  public:
    Study(std::vector<StudyProblem> problems, const StudyOptions& options, const std::string& folder,
          Workers& workers)
        : problems_(std::move(problems)),
          options_(options),
          folder_(folder),
          workers_(workers),
          files_(folder + "/files.csv", filesColumns()),
          qualification_(folder + "/qualification.csv", runColumns()),
          qualified_(folder + "/qualified.csv", qualifiedColumns()),
          runs_(folder + "/runs.csv", runColumns()),
          trees_(folder + "/trees.csv", treeColumns()),
          replays_(folder + "/replay.csv", replayColumns()) {
        requireOnce(qualification_);
        requireOnce(runs_);
    }

    StudyResult run() {
        StudyResult result;
        if (!measureFiles() || !qualify() || !doRuns() || !askAgain()) return result;
        const Measured measured{files_.rows(), ofAble(runs_.rows()), ofAble(replays_.rows())};
        const std::vector<RatioRow> ratios = ratiosOf(measured, options_);
        write("cells.csv", cellColumns(), cellsOf(measured, options_));
        write("ratios.csv", ratioColumns(), ratios);
        write("claims.csv", claimColumns(), judgeClaims(trees_.rows()));
        result.answer = answerOf(ratios, measured, options_);
        replaceText(folder_ + "/answer.txt", result.answer);
        result.isComplete = true;
        return result;
    }

  private:
    template <class Row>
    void write(const char* name, const Columns<Row>& columns, const std::vector<Row>& rows) const {
        replaceText(folder_ + "/" + name, tableText(columns, rows));
    }

    template <class Row>
    static void append(GrowingTable<Row>& table, const Columns<Row>& columns, const std::string& line) {
        Cells cells(1);
        for (const char c : line) {
            if (c == ',')
                cells.emplace_back();
            else
                cells.back() += c;
        }
        Row row;
        if (cells.size() != columns.size() || readCells(columns, cells, row) < cells.size())
            throw std::logic_error("a worker's row does not fit into " + table.file() + ": " + line);
        table.append({row});
    }

    void take(const std::string& text) {
        const std::size_t space = text.find(' ');
        const std::string table = text.substr(0, space), line = text.substr(space + 1);
        if (table == "files") append(files_, filesColumns(), line);
        if (table == "qualification") append(qualification_, runColumns(), line);
        if (table == "runs") append(runs_, runColumns(), line);
        if (table == "trees") append(trees_, treeColumns(), line);
        if (table == "replay") append(replays_, replayColumns(), line);
    }

    bool share(const std::string& what, const std::vector<std::string>& jobs) {
        const Clock::time_point begin = Clock::now();
        Clock::time_point told = begin;
        std::size_t done = 0;
        const auto tellProgress = [&] {
            told = Clock::now();
            std::string left;
            if (done > 0) {
                const double seconds =
                    secondsSince(begin) * static_cast<double>(jobs.size() - done) / static_cast<double>(done);
                left = fmt::format(", about {:.0f} min left", std::max(1.0, seconds / 60));
            }
            options_.report(fmt::format("{}: {} of {} jobs{}", what, done, jobs.size(), left));
        };
        if (!jobs.empty()) tellProgress();
        const auto ended = [&] {
            ++done;
            if (secondsSince(told) > kSecondsBetweenRemarks && done < jobs.size()) tellProgress();
        };
        return workers_.share(
            jobs, [this](const std::string& text) { take(text); },
            [this](const std::string& text) { options_.report(text); }, ended, options_.isStopped);
    }

    /// Removes the rows of a job that was ended while its rows were written. Returns whether the job's rows are all there.
    template <class Row, class IsOfJob>
    static bool hasAll(GrowingTable<Row>& table, const IsOfJob& isOfJob, std::size_t expected) {
        const auto there =
            static_cast<std::size_t>(std::count_if(table.rows().begin(), table.rows().end(), isOfJob));
        if (there < expected && there > 0) table.remove(isOfJob);
        return there >= expected;
    }

    bool measureFiles() {
        std::vector<std::string> jobs;
        for (std::size_t i = 0; i < problems_.size(); ++i) {
            const auto isOfScene = [&](const FilesRow& row) { return row.scene == problems_[i].name; };
            if (!hasAll(files_, isOfScene, plannedEngines(options_).size()))
                jobs.push_back(fmt::format("files {}", i));
        }
        return share("loading and building", jobs);
    }

    /// By seed.
    Outcomes outcomesOf(const std::string& scene, const std::string& planner) const {
        std::map<int, Measure> bySeed;
        for (const RunRow& row : qualification_.rows()) {
            if (row.scene == scene && row.planner == planner) bySeed[row.seed] = row.planningSeconds();
        }
        Outcomes outcomes;
        for (const auto& [seed, seconds] : bySeed) outcomes.push_back(seconds);
        return outcomes;
    }

    bool qualify() {
        std::vector<std::string> jobs;
        for (std::size_t i = 0; i < problems_.size(); ++i) {
            for (const std::string& planner : options_.planners) {
                const Outcomes outcomes = outcomesOf(problems_[i].name, planner);
                if (isDecided(outcomes, options_)) continue;
                std::string job = fmt::format("qualify {} {}", i, planner);
                for (const Measure& seconds : outcomes)
                    job += " " + (seconds ? shortNumber(*seconds) : std::string("-"));
                jobs.push_back(job);
            }
        }
        if (!share("qualifying", jobs)) return false;
        if (!qualified_.rows().empty()) return true;
        std::vector<QualifiedRow> rows;
        for (const StudyProblem& problem : problems_) {
            for (const std::string& planner : options_.planners)
                rows.push_back(judge(problem.name, planner, outcomesOf(problem.name, planner), options_));
        }
        fitSeeds(rows, options_, secondsForRuns());
        qualified_.append(rows);
        return true;
    }

    /// The seconds of all workers together that the study's minutes leave for paired runs: without loading, building, qualification
    /// and replays.
    double secondsForRuns() const {
        const auto workers = static_cast<double>(workers_.count());
        double builds = 0, loads = 0, qualifying = 0;
        for (const FilesRow& row : files_.rows()) {
            builds += row.buildSeconds;
            loads += row.loadSeconds / static_cast<double>(plannedEngines(options_).size());
        }
        for (const RunRow& row : qualification_.rows()) qualifying += row.seconds.value_or(0);
        std::size_t engines = 0;
        for (const EngineGroup& group : replayedGroups(options_)) engines += group.size();
        const double samples = static_cast<double>(options_.planners.size() * problems_.size()) *
                               options_.recordedSeeds,
                     replaying = samples * static_cast<double>(engines) * kMostReplaySeconds *
                                 (options_.repetitions + 1),
                     replayBuilds = builds * static_cast<double>(engines) /
                                    static_cast<double>(plannedEngines(options_).size());
        return 60 * options_.minutes * workers - qualifying - (options_.loads + 3 * workers) * loads -
               (options_.loads + workers) * builds - replaying - replayBuilds;
    }

    bool isUnable(const std::string& planner) const {
        const std::vector<std::string> unable = unablePlanners(qualified_.rows(), options_);
        return std::find(unable.begin(), unable.end(), planner) != unable.end();
    }

    template <class Row>
    std::vector<Row> ofAble(std::vector<Row> rows) const {
        for (const std::string& planner : unablePlanners(qualified_.rows(), options_)) {
            rows.erase(std::remove_if(rows.begin(), rows.end(),
                                      [&](const Row& row) { return row.planner == planner; }),
                       rows.end());
        }
        return rows;
    }

    std::vector<std::string> plannersIn(const std::string& scene) const {
        std::vector<std::string> planners;
        for (const QualifiedRow& row : qualified_.rows()) {
            if (row.scene == scene && row.enters() && !isUnable(row.planner)) planners.push_back(row.planner);
        }
        return planners;
    }

    bool doRuns() {
        for (const std::string& planner : unablePlanners(qualified_.rows(), options_))
            options_.report("unable: " + planner + " enters too few problems");
        const std::vector<Engine> engines = plannedEngines(options_);
        std::set<std::tuple<std::string, std::string, std::string, std::string, int>> done;
        for (const RunRow& row : runs_.rows()) done.insert(keyOf(row));
        std::vector<std::string> jobs;
        for (const QualifiedRow& row : qualified_.rows()) {
            if (isUnable(row.planner)) continue;
            if (row.enters() && row.seeds == 0)
                options_.report(fmt::format("left out, the study's minutes do not suffice: {} in {}",
                                            row.planner, row.scene));
            const auto position = std::find_if(problems_.begin(), problems_.end(), [&](const auto& problem) {
                return problem.name == row.scene;
            });
            for (int seed = 1; seed <= static_cast<int>(row.seeds); ++seed) {
                // All trees run back to back, rotating which goes first, so that slow drifts of the machine affect them equally.
                std::string missing;
                for (std::size_t k = 0; k < engines.size(); ++k) {
                    const std::size_t i = (k + static_cast<std::size_t>(seed - 1)) % engines.size();
                    if (done.count({row.scene, row.planner, engines[i].generalSplit, engines[i].leafSplit,
                                    seed}) == 0)
                        missing += fmt::format(" {}", i);
                }
                if (missing.empty()) continue;
                jobs.push_back(fmt::format("runs {} {} {} {}{}", position - problems_.begin(), row.planner,
                                           seed, shortNumber(row.limitSeconds.value()), missing));
            }
        }
        return share("planning", jobs);
    }

    /// The samples that a planner that enters has left. One that asks from threads of its own leaves none.
    std::size_t samplesOf(const std::string& scene, const std::vector<std::string>& planners) const {
        std::size_t count = 0;
        for (const std::string& planner : planners) {
            for (int seed = 1; seed <= options_.recordedSeeds; ++seed)
                count += hasSample(folder_, scene, planner, seed);
        }
        return count;
    }

    /// The thesis's tables and the replays. The tables of a large scene take longest, and begin first.
    bool askAgain() {
        std::vector<std::string> jobs;
        for (std::size_t i = problems_.size(); i-- > 0;) {
            const std::string& scene = problems_[i].name;
            const auto isOfScene = [&](const TreeRow& row) { return row.scene == scene; };
            if (!hasAll(trees_, isOfScene, treeRowCount(scene)))
                jobs.push_back(fmt::format("trees {} {}", i, joined(plannersIn(scene), " ")));
        }
        const std::vector<EngineGroup> groups = replayedGroups(options_);
        for (std::size_t i = 0; i < problems_.size(); ++i) {
            const std::vector<std::string> planners = plannersIn(problems_[i].name);
            const std::size_t samples = samplesOf(problems_[i].name, planners);
            for (std::size_t k = 0; k < groups.size() && samples > 0; ++k) {
                const EngineGroup& group = groups[k];
                const auto isOfJob = [&](const ReplayRow& row) {
                    return row.scene == problems_[i].name &&
                           std::find(group.begin(), group.end(), row) != group.end();
                };
                if (!hasAll(replays_, isOfJob, samples * group.size()))
                    jobs.push_back(fmt::format("replay {} {} {}", i, k, joined(planners, " ")));
            }
        }
        return share("asking again", jobs);
    }

    std::vector<StudyProblem> problems_;
    const StudyOptions& options_;
    std::string folder_;
    Workers& workers_;
    GrowingTable<FilesRow> files_;
    GrowingTable<RunRow> qualification_;
    GrowingTable<QualifiedRow> qualified_;
    GrowingTable<RunRow> runs_;
    GrowingTable<TreeRow> trees_;
    GrowingTable<ReplayRow> replays_;
};

}  // namespace

StudyResult studyLeafStrategies(std::size_t count, const LoadProblem& load, const StudyOptions& options,
                                const std::string& folder, Workers& workers) {
    if (count == 0) throw std::invalid_argument("there is no problem to study, expected at least one");
    std::vector<StudyProblem> problems;
    for (std::size_t i = 0; i < count; ++i) {
        if (options.mustStop()) return {};
        problems.push_back(load(i));
    }
    requireDifferentNames(problems);
    makeFolder(folder + "/calls");
    const FolderLock lock(folder);
    requireSettings(settingsOf(problems, options), folder);
    for (StudyProblem& problem : problems) {  // the workers read them again
        problem.part = {};
        problem.obstacles = {};
    }
    return Study(std::move(problems), options, folder, workers).run();
}

}  // namespace clearway::study
