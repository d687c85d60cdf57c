#include "program/cli/study.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "clearway/planning/planners.h"
#include "core/lines.h"
#include "core/replace_file.h"
#include "planning/objectives/objectives.h"
#include "program/cli/command_line.h"
#include "program/cli/interrupts.h"
#include "program/cli/load_guard.h"
#include "program/cli/planning_scene.h"
#include "program/cli/print.h"
#include "program/cli/print_study.h"
#include "program/cli/scene_record.h"
#include "program/cli/tree_options.h"
#include "program/scenes/scenes.h"
#include "program/study/study.h"

namespace clearway::cli {

namespace {

namespace fs = std::filesystem;

constexpr const char* kProblems = "[PROBLEM.cfg...]";
constexpr const char* kLeafStrategies = "leaf-strategies";

/// A scene that is made when no problem is given.
struct MadeScene {
    const char* name;
    std::size_t partTriangles, environmentTriangles;  ///< 0: the scene's own
};
constexpr MadeScene kFullScenes[] = {{"tunnel-console", 0, 0}, {"cembox", 0, 0}, {"large-environment", 0, 0}};
constexpr MadeScene kShortScenes[] = {{"tunnel-console-3", 15000, 60000}, {"cembox-2", 2000, 8000}};

CommandLine studyCommandLine() {
    CommandLine commandLine;
    commandLine.usage = "clearway bench --study leaf-strategies [PROBLEM.cfg...] --out DIR [options]";
    commandLine.purpose =
        "How splitting leaves changes what planners need: runs planners with every leaf split and seed, and "
        "asks "
        "what they\nasked again of trees of other splits, leaf sizes, widths and instruction sets. Without a "
        "problem "
        "it makes the scenes\ntunnel-console, cembox and large-environment at full size.\n"
        "DIR then holds runs.csv, replay.csv, statistics.csv, summary.csv and logs for OMPL's statistics "
        "script. A "
        "study that\nwas stopped goes on with the same command: what DIR holds is not done again.";
    commandLine.positional = {kProblems};
    commandLine.options.add_options()                                                         //
        ("study", optionValue("NAME"), "leaf-strategies")                                     //
        ("out", optionValue("DIR"), "folder of the study, made if need be")                   //
        ("time", optionValue("S"), "seconds for each run (20; short 0.5)")                    //
        ("memory", optionValue("MB"), "that the program may have while planners run (8192)")  //
        ("seeds", optionValue("N"), "runs of each planner with each strategy (10; short 2)")  //
        ("planner", optionValues("NAME[:OBJECTIVE]"),
         "in place of RRTConnect, KPIECE1, PRM, RRTstar and BITstar:max_min_clearance (short: RRTConnect and "
         "that); may be repeated")                                                            //
        ("general-split", optionValues("NAME"), "in place of axis and sah; may be repeated")  //
        ("leaf-split", optionValues("NAME"),
         "in place of none, chain, edge and all; the first is what others are compared with; may be "
         "repeated")                                                      //
        ("repetitions", optionValue("N"), "of each replay (7; short 1)")  //
        ("short", "small scenes, few and short runs, fewer replays: to see that all works");
    addCacheOption(commandLine);
    return commandLine;
}

study::StudyPlanner parsePlanner(const std::string& text) {
    const std::size_t colon = text.find(':');
    study::StudyPlanner planner{planning::plannerClassName(text.substr(0, colon)), ""};
    if (colon != std::string::npos) planner.objective = planning::objectiveName(text.substr(colon + 1));
    return planner;
}

std::vector<std::string> chosen(const Options& options, const std::string& name,
                                const std::vector<std::string>& known,
                                const std::vector<std::string>& usual) {
    const std::vector<std::string> given = options.texts(name);
    for (const std::string& each : given) {
        if (std::find(known.begin(), known.end(), each) != known.end()) continue;
        std::string all;
        for (const std::string& one : known) all += (all.empty() ? "" : ", ") + one;
        throw std::invalid_argument("--" + name + " is '" + each + "', expected one of " + all);
    }
    return given.empty() ? usual : given;
}

study::StudyOptions studyOptions(const Options& options) {
    study::StudyOptions result;
    if (options.has("short")) {
        result.isShort = true;
        result.seconds = 0.5;
        result.seeds = 2;
        result.repetitions = 1;
        result.sampling = {8, 25, 1};
        result.tablePoses = 100;
        result.planners = {{"RRTConnect", ""}, {"BITstar", "max_min_clearance"}};
    }
    if (options.has("time")) result.seconds = options.positive("time");
    if (options.has("memory")) result.megabytes = options.positive("memory");
    if (options.has("seeds")) result.seeds = static_cast<int>(options.integer("seeds", 1, 10000));
    if (options.has("repetitions"))
        result.repetitions = static_cast<int>(options.integer("repetitions", 1, 1000));
    if (options.has("planner")) result.planners.clear();
    for (const std::string& planner : options.texts("planner"))
        result.planners.push_back(parsePlanner(planner));
    result.generalSplits = chosen(options, "general-split", generalSplitNames(), result.generalSplits);
    result.leafSplits = chosen(options, "leaf-split", leafSplitNames(), result.leafSplits);
    result.isStopped = isInterrupted;
    result.tell = [](const std::string& line) { std::cerr << "clearway: " << oneLine(line) << std::endl; };
    return result;
}

/// What names a scene in tables and files.
std::string plainName(const std::string& problemFile) {
    std::string name = fs::path(problemFile).stem().string();
    for (char& c : name) {
        const bool isPlain = std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '.' || c == '_';
        if (!isPlain) c = '_';
    }
    return name;
}

/// The scenes' problems, made in the folder unless they are there. Fewer when it was interrupted.
std::vector<std::string> makeScenes(bool isShort, const std::string& folder) {
    std::vector<MadeScene> scenes(std::begin(kFullScenes), std::end(kFullScenes));
    if (isShort) scenes.assign(std::begin(kShortScenes), std::end(kShortScenes));
    std::vector<std::string> problems;
    for (const MadeScene& wanted : scenes) {
        if (isInterrupted()) break;
        const scenes::NamedScene& named = scenes::sceneNamed(wanted.name);
        const std::string at = folder + "/scenes/" + named.name;
        scenes::SceneOptions options = named.defaults;
        if (wanted.partTriangles > 0) options.partTriangles = wanted.partTriangles;
        if (wanted.environmentTriangles > 0) options.environmentTriangles = wanted.environmentTriangles;
        const std::string kept = at + "/complete";  // named in it: the problem's file
        if (!fs::exists(kept)) {
            printRow("scene", at);
            const scenes::GeneratedScene made = named.make(options);
            const scenes::SceneFiles files = writeScene(made, at);
            recordScene({named, options}, files, made.environment, false);
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
    study.part = guardedLoadPart(study.problem);
    study.obstacles = obstaclesOf(study.problem, guardedLoadWorlds(study.problem));
    if (study.obstacles.hasSolids()) study.partSolids = makeSolids(study.part).solids;
    const fs::path poses = fs::path(file).parent_path() / (fs::path(file).stem().string() + "_replay.poses");
    if (fs::exists(poses)) study.replayPoses = readPoses(poses.string()).poses;
    return study;
}

int tellInterrupted(const std::string& folder) {
    printRow("study", folder + ", interrupted: the same command goes on with it");
    requirePrinted();
    return kAnswerIsNo;
}

}  // namespace

int study(const Arguments& arguments) {
    const std::optional<Options> given = parse(studyCommandLine(), arguments);
    if (!given) return kDone;
    if (given->text("study") != kLeafStrategies) {
        throw std::invalid_argument("--study is '" + given->text("study") + "', expected " + kLeafStrategies);
    }
    study::StudyOptions options = studyOptions(*given);
    const std::string folder = given->text("out");
    std::vector<std::string> files = given->texts(kProblems);
    for (const std::string& file : files)
        readProblem(file);  // what is wrong with one is said before long work
    options.cache = cacheFolder(*given);
    heedInterrupts();

    if (files.empty()) files = makeScenes(options.isShort, folder);
    std::vector<study::StudyProblem> problems;
    for (const std::string& file : files) {
        if (!isInterrupted()) problems.push_back(loadProblem(file));
    }
    if (isInterrupted()) return tellInterrupted(folder);
    const study::StudyResult result = studyLeafStrategies(problems, options, folder);
    if (!result.isComplete) return tellInterrupted(folder);
    printStudy(result);
    printRow("study", folder);
    requirePrinted();
    return kDone;
}

}  // namespace clearway::cli
