// The program clearway-study: answers one question by planner runs and replays by the thousand.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>

#include "clearway/planning/planners.h"
#include "clearway/targets.h"
#include "core/replace_file.h"
#include "core/text.h"
#include "demos/scenes/record_scene.h"
#include "demos/scenes/scenes.h"
#include "demos/study/study.h"
#include "program/options/print.h"
#include "program/options/program.h"
#include "program/options/shared_options.h"

namespace clearway::cli {

namespace {

namespace fs = std::filesystem;

/// A problem of the study: a file of clearway's data, or a scene that is made.
struct StudiedScene {
    const char* name;  ///< in tables
    const char* from;  ///< a file in the folder of data, or a scene's name
    double clearance = 0;
    std::size_t partTriangles = 0, environmentTriangles = 0;  ///< 0: the scene's defaults, as for clearance
};
constexpr StudiedScene kFullScenes[] = {{"gates", "gates/gates.cfg"},
                                        {"window", "window/window.cfg"},
                                        {"bracket", "bracket/bracket.cfg"},
                                        {"puzzle", "puzzle/puzzle.cfg"},
                                        {"sheets", "sheets-1"},
                                        {"slabs", "slabs-1"},
                                        {"cembox", "cembox-2"},
                                        {"tunnel-console", "tunnel-console-3"},
                                        {"console-2mm", "tunnel-console-3", 2},
                                        {"large-environment", "large-environment-2"}};
constexpr StudiedScene kShortScenes[] = {
    {"gates", "gates/gates.cfg"}, {"window", "window/window.cfg"}, {"cembox", "cembox-2", 0, 2000, 8000}};

struct StudyArguments {
    std::vector<std::string> problems;
    std::string folder;
    study::StudyOptions options;
};

study::StudyOptions shortStudy() {
    study::StudyOptions options;
    options.isShort = true;
    options.seeds = 3;
    options.qualifyingSeconds = 0.5;
    options.mostMedian = 0.2;
    options.leastLimit = 5;
    options.minutes = 1;
    options.repetitions = options.loads = 1;
    options.sampling = {8, 25, 1};
    options.tablePoses = 100;
    options.generalSplits = {"axis", "sah"};
    options.planners = {"RRTConnect", "SlidingRRTConnect", "PRM"};
    return options;
}

bool readArguments(const Arguments& arguments, StudyArguments& given) {
    constexpr auto kRequired = CommandLine::Count::kRequired, kRepeatable = CommandLine::Count::kRepeatable;
    study::StudyOptions& options = given.options;
    std::vector<std::string> planners;
    CommandLine line(
        "clearway-study [PROBLEM.cfg...] --out DIR [options]",
        "Measures what the leaves of trees change for planners, from files to a first path. Planners "
        "qualify for the problems\n"
        "that they mostly solve within a second. Then they plan with every tree and seed, and their queries "
        "are repeated in\n"
        "trees of other leaf sizes, widths and instruction sets. Without a problem, ten are taken: four of "
        "clearway's data,\n"
        "and the scenes cembox, tunnel-console (twice), large-environment, sheets and slabs.\n"
        "The answer is printed in two sentences; DIR then holds the tables. Runs are timed one at a time on "
        "each processor.\n"
        "The same command continues a stopped study and repeats nothing that DIR holds.");
    line.argument("[PROBLEM.cfg...]", appendedTo(given.problems));
    line.option("--out DIR", "folder of the study, made if need be", folder(given.folder), kRequired);
    // --short is read before the options below, which then change its values.
    line.option("--short", "small scenes, few and short runs, fewer trees: a minute",
                [&](const std::string&) { options = shortStudy(); });
    line.option("--minutes M",
                "for all of it (100; short 1): where they do not suffice, half the seeds run, "
                "then the slowest planners are left out",
                positive(options.minutes));
    line.option("--seeds N", "runs of each planner with each tree (10; short 3)",
                integer<int>(options.seeds, 1, 10000));
    line.option(
        "--planner NAME",
        "in place of RRTConnect, SlidingRRTConnect, KPIECE1, PRM, RRTstar, BITstar, LazyPRM and "
        "AnytimePathShortening (short: RRTConnect, SlidingRRTConnect and PRM); may be repeated",
        [&](const std::string& text) { planners.push_back(planning::plannerClassName(text)); }, kRepeatable);
    if (!line.parse(arguments)) return false;
    if (!planners.empty()) options.planners = planners;
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

struct StudiedProblem {
    std::string name, file;
};

/// Makes the scene in the folder, unless it is there, and returns its problem's file. Returns "" when interrupted.
std::string makeScene(const StudiedScene& wanted, const std::string& folder) {
    const scenes::NamedScene& named = scenes::sceneNamed(wanted.from);
    const std::string at = folder + "/scenes/" + wanted.name;
    scenes::SceneOptions options = named.defaults;
    if (wanted.clearance > 0) options.clearance = wanted.clearance;
    if (wanted.partTriangles > 0) options.partTriangles = wanted.partTriangles;
    if (wanted.environmentTriangles > 0) options.environmentTriangles = wanted.environmentTriangles;
    const std::string kept = at + "/complete";  // holds the name of the problem's file
    if (!fs::exists(kept)) {
        printRow("scene", at);
        const scenes::GeneratedScene made = named.make(options);
        const scenes::SceneFiles files = writeScene(made, at);
        recordScene({named, options}, files, made.environment, false);
        if (isInterrupted()) return "";  // the scene is not complete; the next run makes it anew
        const std::string problem = fs::path(files.problem).filename().string();
        replaceFile(kept, [&](std::ostream& out) { out << problem << "\n"; });
    }
    return at + "/" + readLines(kept, "the name of a problem's file").at(0);
}

/// The problems of the command line, else the study's own. Returns fewer when interrupted.
std::vector<StudiedProblem> studiedProblems(const StudyArguments& given) {
    std::vector<StudiedProblem> problems;
    for (const std::string& file : given.problems) problems.push_back({plainName(file), file});
    if (!problems.empty()) return problems;
    std::vector<StudiedScene> scenes(std::begin(kFullScenes), std::end(kFullScenes));
    if (given.options.isShort) scenes.assign(std::begin(kShortScenes), std::end(kShortScenes));
    for (const StudiedScene& scene : scenes) {
        const bool isOfData = fs::path(scene.from).extension() == ".cfg";
        const std::string file =
            isOfData ? CLEARWAY_DATA_DIR "/" + std::string(scene.from) : makeScene(scene, given.folder);
        if (isInterrupted()) return problems;
        problems.push_back({scene.name, file});
    }
    return problems;
}

study::StudyProblem loadProblem(const StudiedProblem& studied) {
    const std::string& file = studied.file;
    study::StudyProblem study;
    study.name = studied.name;
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

int runStudy(const Arguments& arguments) {
    currentTarget();  // refuses CLEARWAY_TARGET before any work
    StudyArguments given;
    if (!readArguments(arguments, given)) return kDone;
    for (const std::string& file : given.problems)
        readProblem(file);  // refuses a faulty file before long work
    heedInterrupts();
    std::vector<StudiedProblem> problems;
    const auto load = [&](std::size_t position) {
        if (problems.empty()) problems = studiedProblems(given);  // a worker finds the scenes made
        return loadProblem(problems.at(position));
    };
    // Workers are copies of this process, which has no threads yet; making scenes starts some.
    study::Workers workers(0, study::studyJobs(load, given.options, given.folder));
    problems = studiedProblems(given);
    study::StudyResult result;
    if (!isInterrupted())
        result = study::studyLeafStrategies(problems.size(), load, given.options, given.folder, workers);
    if (!result.isComplete) {
        printRow("study", given.folder + (isInterrupted() ? ", interrupted" : ", stopped") +
                              ": the same command continues it");
        requirePrinted();
        return kAnswerIsNo;
    }
    std::cout << result.answer;
    printRow("study", given.folder);
    requirePrinted();
    return kDone;
}

}  // namespace
}  // namespace clearway::cli

int main(int argc, char** argv) {
    return clearway::cli::runProgram(argc, argv, "clearway-study", clearway::cli::runStudy);
}
