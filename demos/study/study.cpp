#include "demos/study/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "clearway/targets.h"
#include "core/hash.h"
#include "core/number.h"
#include "core/replace_file.h"
#include "core/text.h"
#include "demos/study/replayer.h"

namespace clearway::study {
namespace {

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
    std::vector<std::string> planners;
    for (const StudyPlanner& planner : options.planners) {
        planners.push_back(planner.name + (planner.objective.empty() ? "" : ":" + planner.objective));
    }
    const CallSampling& sampling = options.sampling;
    Settings settings = {
        {"planners", joined(planners, " ")},
        {"general splits", joined(options.generalSplits, " ")},
        {"leaf splits", joined(options.leafSplits, " ")},
        {"seeds", std::to_string(options.seeds)},
        {"seconds", shortNumber(options.seconds)},
        {"sampled blocks", fmt::format("{} of {}", sampling.blocks, sampling.callsPerBlock)},
        {"repetitions", std::to_string(options.repetitions)},
        {"table poses", std::to_string(options.tablePoses)},
        {"short", options.isShort ? "yes" : "no"},
        {"processor", processorName()},
        {"instructions", availableTargets().front()},
    };
    std::vector<std::string> names;
    for (const StudyProblem& problem : problems) names.push_back(problem.name);
    settings.push_back({"scenes", joined(names, " ")});
    for (const StudyProblem& problem : problems) {
        settings.push_back({"scene " + problem.name, hashOf(problem.fingerprint())});
    }
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

void requireOptions(const std::vector<StudyProblem>& problems, const StudyOptions& options) {
    if (problems.empty()) throw std::invalid_argument("there is no problem to study, expected at least one");
    for (std::size_t i = 0; i < problems.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            if (problems[i].name != problems[k].name) continue;
            throw std::invalid_argument("two problems are named '" + problems[i].name +
                                        "', expected different names");
        }
    }
    if (options.leafSplits.size() < 2) {
        throw std::invalid_argument("there is one leaf split, expected at least two to compare");
    }
}

constexpr std::size_t kPosesTogether = 25;  ///< consecutive poses, as they were recorded

/// The poses of the problem, or the states of its recorded calls. If there are too many, takes stretches of
/// consecutive poses, spread evenly.
std::vector<Pose> tablePoses(const StudyProblem& problem, const StudyOptions& options,
                             const std::string& folder) {
    std::vector<Pose> all = problem.replayPoses;
    for (const StudyPlanner& planner : options.planners) {
        if (!problem.replayPoses.empty()) break;
        for (int seed = 1; seed <= options.seeds; ++seed) {
            const auto blocks = readCalls(callsFile(folder, problem.name, planner.name, seed));
            for (const Pose& pose : posesOf(problem.problem, blocks)) all.push_back(pose);
        }
    }
    const auto most = static_cast<std::size_t>(options.tablePoses);
    if (all.size() <= std::max(most, kPosesTogether)) return all;
    std::vector<Pose> some;
    const std::size_t runs = (most + kPosesTogether - 1) / kPosesTogether;
    for (std::size_t i = 0; i < most; ++i) {
        some.push_back(all[(all.size() - kPosesTogether) * (i / kPosesTogether) / runs + i % kPosesTogether]);
    }
    return some;
}

/// Does the runs of all problems, before the first replay: other processes then need not wait for this one. Returns whether
/// the table has all of them.
bool runElsewhere(const std::vector<StudyProblem>& problems, const StudyOptions& options,
                  const std::string& folder, GrowingTable<RunRow>& runs) {
    makeFolder(folder + "/calls");
    std::vector<std::size_t> missing;
    for (std::size_t i = 0; i < problems.size(); ++i) {
        for (const std::size_t run : missingRuns(problems[i], i, options, runs)) missing.push_back(run);
    }
    return options.doRuns(missing, [&](const StudyRun& run) { keepRun(run, options, folder, runs); });
}

}  // namespace

StudyResult studyLeafStrategies(const std::vector<StudyProblem>& problems, const StudyOptions& options,
                                const std::string& folder) {
    requireOptions(problems, options);
    makeFolder(folder);
    const FolderLock lock(folder);
    requireSettings(settingsOf(problems, options), folder);
    GrowingTable<RunRow> runs(folder + "/runs.csv", runColumns());
    GrowingTable<ReplayRow> replays(folder + "/replay.csv", replayColumns());
    GrowingTable<TreeRow> trees(folder + "/trees.csv", treeColumns());
    StudyResult result;
    if (options.doRuns && !runElsewhere(problems, options, folder, runs)) return result;
    for (std::size_t i = 0; i < problems.size(); ++i) {
        const StudyProblem& problem = problems[i];
        options.report(fmt::format("scene {} of {}, {}: runs, then replays, then the trees' tables", i + 1,
                                   problems.size(), problem.name));
        if (!runPlanners(problem, options, folder, runs)) return result;
        if (!replayCalls(problem, options, folder, runs.rows(), replays)) return result;
        if (!measureTrees(problem, tablePoses(problem, options, folder), options, trees)) return result;
        writeStudyLogs(problem, options, runs.rows(), folder);
    }
    result.statistics = statisticsOf(runs.rows(), replays.rows(), options.leafSplits.front());
    result.summary = summaryOf(runs.rows(), replays.rows());
    result.trees = trees.rows();
    result.claims = judgeClaims(trees.rows());
    replaceText(folder + "/statistics.csv", tableText(statisticColumns(), result.statistics));
    replaceText(folder + "/summary.csv", tableText(summaryColumns(), result.summary));
    replaceText(folder + "/claims.csv", tableText(claimColumns(), result.claims));
    result.isComplete = true;
    return result;
}

}  // namespace clearway::study
