// The program clearway-study: answers one question by planner runs and replays by the hundred.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <set>

#include "clearway/planning/objectives.h"
#include "clearway/planning/planners.h"
#include "clearway/targets.h"
#include "core/replace_file.h"
#include "core/text.h"
#include "demos/scenes/record_scene.h"
#include "demos/scenes/scenes.h"
#include "demos/study/print_study.h"
#include "demos/study/study.h"
#include "demos/study/study_run_text.h"
#include "program/cli/run_on_ranks.h"
#include "program/options/print.h"
#include "program/options/program.h"
#include "program/options/shared_options.h"

namespace clearway::cli {

namespace {

namespace fs = std::filesystem;

/// A scene that is made when no problem file is given.
struct MadeScene {
    const char* name;
    std::size_t partTriangles, environmentTriangles;  ///< 0: the scene's default number
};
constexpr MadeScene kFullScenes[] = {{"tunnel-console", 0, 0}, {"cembox", 0, 0}, {"large-environment", 0, 0}};
constexpr MadeScene kShortScenes[] = {{"tunnel-console-3", 12100, 41000}, {"cembox-2", 2000, 8000}};

struct StudyArguments {
    std::vector<std::string> problems;
    std::string folder;
    study::StudyOptions options;
};

study::StudyOptions shortStudy() {
    study::StudyOptions options;
    options.isShort = true;
    options.seconds = 0.5;
    options.seeds = 2;
    options.repetitions = 1;
    options.sampling = {8, 25, 1};
    options.tablePoses = 100;
    options.planners = {{"RRTConnect", ""}, {"BITstar", "max_min_clearance"}};
    return options;
}

study::StudyPlanner parsePlanner(const std::string& text) {
    const std::size_t colon = text.find(':');
    study::StudyPlanner planner{planning::plannerClassName(text.substr(0, colon)), ""};
    if (colon != std::string::npos) planner.objective = planning::objectiveName(text.substr(colon + 1));
    return planner;
}

bool readArguments(const Arguments& arguments, StudyArguments& given) {
    constexpr auto kRequired = CommandLine::Count::kRequired, kRepeatable = CommandLine::Count::kRepeatable;
    study::StudyOptions& options = given.options;
    TreeChoice trees;
    std::vector<study::StudyPlanner> planners;
    std::vector<std::string> generalSplits, leafSplits;
    CommandLine line("clearway-study [PROBLEM.cfg...] --out DIR [options]",
                     "Measures how leaf splits change the work of planners: runs planners with every leaf "
                     "split and seed, then\n"
                     "repeats their queries in trees of other splits, leaf sizes, widths and instruction "
                     "sets. Without a problem\n"
                     "it makes the scenes tunnel-console, cembox and large-environment at full size.\n"
                     "DIR then holds runs.csv, replay.csv, statistics.csv, summary.csv and logs for OMPL's "
                     "statistics script.\n"
                     "The same command continues a stopped study and repeats nothing that DIR holds.\n"
                     "Under `mpirun -n N` or `srun -n N` each of N ranks does its share of the planners' "
                     "runs; one rank does\n"
                     "the rest, which is timed.");
    line.argument("[PROBLEM.cfg...]", appendedTo(given.problems));
    line.option("--out DIR", "folder of the study, made if need be", folder(given.folder), kRequired);
    // --short is read before the options below, which then change its values.
    line.option("--short", "small scenes, few and short runs, fewer replays: shows that everything works",
                [&](const std::string&) { options = shortStudy(); });
    line.option("--time S", "seconds for each run (20; short 0.5)", positive(options.seconds));
    line.option("--memory MB", "memory growth limit in MB while planners run (8192)",
                positive(options.megabytes));
    line.option("--seeds N", "runs of each planner with each strategy (10; short 2)",
                integer<int>(options.seeds, 1, 10000));
    line.option(
        "--planner NAME[:OBJECTIVE]",
        "in place of RRTConnect, KPIECE1, PRM, RRTstar and BITstar:max_min_clearance (short: RRTConnect and "
        "BITstar:max_min_clearance); may be repeated",
        [&](const std::string& text) { planners.push_back(parsePlanner(text)); }, kRepeatable);
    line.option(
        "--general-split NAME", "in place of axis and sah; may be repeated",
        [&](const std::string& name) { generalSplits.push_back(oneOf(name, generalSplitNames())); },
        kRepeatable);
    line.option(
        "--leaf-split NAME",
        "in place of none, chain, edge and all; the others are compared with the first; may be repeated",
        [&](const std::string& name) { leafSplits.push_back(oneOf(name, leafSplitNames())); }, kRepeatable);
    line.option("--repetitions N", "repetitions of each replay (7; short 1)",
                integer<int>(options.repetitions, 1, 1000));
    addCache(line, trees);
    if (!line.parse(arguments)) return false;
    if (!planners.empty()) options.planners = planners;
    if (!generalSplits.empty()) options.generalSplits = generalSplits;
    if (!leafSplits.empty()) options.leafSplits = leafSplits;
    options.build = [trees](const Mesh& mesh, const BuildOptions& build,
                            const std::optional<QueryRange>& range) {
        return trees.build(mesh, build, range);
    };
    options.isStopped = isInterrupted;
    options.tell = [](const std::string& text) { std::cerr << "clearway: " << oneLine(text) << std::endl; };
    return true;
}

/// The problem's name as tables and files show it.
std::string plainName(const std::string& problemFile) {
    std::string name = fs::path(problemFile).stem().string();
    for (char& c : name) {
        const bool isPlain = std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '.' || c == '_';
        if (!isPlain) c = '_';
    }
    return name;
}

/// Makes the scenes in the folder, unless they are there, and returns their problem files. Returns fewer
/// files when interrupted.
std::vector<std::string> makeScenes(bool isShort, const std::string& folder) {
    std::vector<MadeScene> scenes(std::begin(kFullScenes), std::end(kFullScenes));
    if (isShort) scenes.assign(std::begin(kShortScenes), std::end(kShortScenes));
    std::vector<std::string> problems;
    for (const MadeScene& wanted : scenes) {
        if (isInterrupted()) break;
        const std::string name = wanted.name;
        const scenes::NamedScene& named = scenes::sceneNamed(name);
        const std::string at = folder + "/scenes/" + named.name;
        scenes::SceneOptions options = named.defaults;
        if (wanted.partTriangles > 0) options.partTriangles = wanted.partTriangles;
        if (wanted.environmentTriangles > 0) options.environmentTriangles = wanted.environmentTriangles;
        const std::string kept = at + "/complete";  // holds the name of the problem's file
        if (!fs::exists(kept)) {
            printRow("scene", at);
            const scenes::GeneratedScene made = named.make(options);
            const scenes::SceneFiles files = writeScene(made, at);
            recordScene({named, options}, files, made.environment, false);
            if (isInterrupted()) break;  // the scene is not complete; the next run makes it anew
            const std::string problem = fs::path(files.problem).filename().string();
            replaceFile(kept, [&](std::ostream& out) { out << problem << "\n"; });
        }
        problems.push_back(at + "/" + readLines(kept, "the name of a problem's file").at(0));
    }
    return problems;
}

study::StudyProblem loadProblem(const std::string& file) {
    study::StudyProblem study;
    study.name = plainName(file);
    study.problem = readProblem(file);
    SceneMeshes meshes = guardedLoadMeshes(study.problem);
    study.obstacles = obstaclesOf(study.problem, meshes.worlds);
    study.part = std::move(meshes.part);
    if (study.obstacles.hasSolids()) study.partSolids = makeSolids(study.part).solids;
    std::vector<std::string> notes;
    study.shrunk =
        shrinkForOverlaps(study.problem, study.part, study.obstacles, notes, interruptibleLoading());
    printWarnings(notes);
    const fs::path poses = fs::path(file).parent_path() / (fs::path(file).stem().string() + "_replay.poses");
    if (fs::exists(poses)) study.replayPoses = readPoses(poses.string()).poses;
    return study;
}

int tellIncomplete(const std::string& folder) {
    printRow("study", folder + (isInterrupted() ? ", interrupted" : ", runs lost") +
                          ": the same command continues it");
    requirePrinted();
    return kAnswerIsNo;
}

/// Does a study's runs by their numbers, for the ranks.
class NumberedRuns {
  public:
    NumberedRuns(const std::vector<study::StudyProblem>& problems, const study::StudyOptions& options)
        : problems_(problems), options_(options), planned_(plannedRuns(options)) {}

    const study::PlannedRun& operator[](std::size_t run) const { return planned_[run % planned_.size()]; }

    std::string nameOf(std::size_t run) const {
        return fmt::format("problem {}, {}", run / planned_.size() + 1, (*this)[run].name());
    }

    /// Returns the run's number and text.
    std::optional<std::string> doRun(std::size_t run) {
        if (options_.mustStop()) return std::nullopt;
        const study::StudyProblem& problem = problems_.at(run / planned_.size());
        // One scene alone is kept: those of all strategies, on every rank of a machine, might fill its memory.
        const std::pair at(run / planned_.size(), (*this)[run].strategy);
        if (!scene_ || at != sceneAt_) scene_.emplace(buildScene(problem, (*this)[run].engine, options_));
        sceneAt_ = at;
        const auto done = runPlanned(problem, *scene_, options_, (*this)[run]);
        return done ? std::optional(std::to_string(run) + " " + textOf(*done)) : std::nullopt;
    }

  private:
    const std::vector<study::StudyProblem>& problems_;
    const study::StudyOptions& options_;
    std::vector<study::PlannedRun> planned_;
    std::optional<Scene> scene_;
    std::pair<std::size_t, std::size_t> sceneAt_;  ///< its problem and strategy
};

/// See study::StudyOptions::doRuns. The other ranks end when all runs have, because replays follow, which are timed. Reports lost
/// runs.
bool shareOut(study::Ranks& ranks, NumberedRuns& numbered, const study::StudyOptions& options,
              std::vector<std::size_t> runs, const std::function<void(const study::StudyRun&)>& keep) {
    // Every rank gets as many runs of each planner, because planners differ most in the time that they take.
    std::stable_sort(runs.begin(), runs.end(), [&](std::size_t a, std::size_t b) {
        return numbered[a].planner.name < numbered[b].planner.name;
    });
    std::vector<std::string> jobs;
    for (const std::size_t run : runs) jobs.push_back(std::to_string(run));
    std::set<std::size_t> lost(runs.begin(), runs.end());
    study::TimeLeft left(runs.size(), options.seconds / ranks.count());
    const auto doRun = [&](const std::string& job) {
        const std::size_t run = std::stoul(job);
        options.report(fmt::format("run {} of {}, {}, {} for all runs", left.done() + 1, left.all(),
                                   numbered.nameOf(run), left.text()));
        return numbered.doRun(run);
    };
    const auto take = [&](const std::string& text) {
        keep(study::readStudyRun(text.substr(text.find(' '))));
        lost.erase(std::stoul(text));
        left.step();
    };
    ranks.share(jobs, doRun, take, /*pause*/ [] {});
    for (const std::size_t run : lost) options.report("warning: the run is lost: " + numbered.nameOf(run));
    if (lost.empty()) ranks.leave();
    return lost.empty();
}

std::vector<study::StudyProblem> loadProblems(const StudyArguments& given) {
    std::vector<std::string> files = given.problems;
    if (files.empty()) files = makeScenes(given.options.isShort, given.folder);
    std::vector<study::StudyProblem> problems;
    for (const std::string& file : files) {
        if (!isInterrupted()) problems.push_back(loadProblem(file));
    }
    return problems;
}

/// ranks: null unless mpirun started this process.
int runStudy(const Arguments& arguments, study::Ranks* ranks) {
    StudyArguments given;
    if (!readArguments(arguments, given)) return kDone;
    for (const std::string& file : given.problems)
        readProblem(file);  // refuses a faulty file before long work
    heedInterrupts();

    std::vector<study::StudyProblem> problems;
    NumberedRuns numbered(problems, given.options);
    if (ranks && ranks->rank() > 0) {
        ranks->serve([&](const std::string& run) {
            if (problems.empty()) problems = loadProblems(given);  // rank 0 has made their scenes
            return numbered.doRun(std::stoul(run));
        });
        return kDone;
    }
    problems = loadProblems(given);
    if (isInterrupted()) return tellIncomplete(given.folder);
    if (ranks) {
        given.options.doRuns = [&](const auto& runs, const auto& keep) {
            return shareOut(*ranks, numbered, given.options, runs, keep);
        };
    }
    const study::StudyResult result = studyLeafStrategies(problems, given.options, given.folder);
    if (!result.isComplete) return tellIncomplete(given.folder);
    printStudy(result);
    printRow("study", given.folder);
    requirePrinted();
    return kDone;
}

int studyOnRanks(const Arguments& arguments) {
    currentTarget();  // refuses CLEARWAY_TARGET before any work
    return runOnRanks([&](study::Ranks* ranks) { return runStudy(arguments, ranks); });
}

}  // namespace
}  // namespace clearway::cli

int main(int argc, char** argv) {
    return clearway::cli::runProgram(argc, argv, "clearway-study", clearway::cli::studyOnRanks);
}
