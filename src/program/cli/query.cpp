// clearway query: one question at every pose of a file, the answers as a table, and what they cost.
#include "clearway/query.h"

#include <algorithm>
#include <stdexcept>

#include "clearway/model.h"
#include "clearway/problem.h"
#include "clearway/targets.h"
#include "core/number.h"
#include "core/replace_file.h"
#include "program/cli/command_line.h"
#include "program/cli/load_guard.h"
#include "program/cli/print.h"
#include "program/cli/query_run.h"
#include "program/cli/tree_options.h"

namespace clearway::cli {

namespace {

CommandLine queryCommandLine() {
    CommandLine commandLine;
    commandLine.usage =
        "clearway query --part MESH --environment MESH --poses FILE --query distance|collide|within=D "
        "[options]";
    commandLine.purpose =
        "Asks one question about the part at every pose (environment coordinates of the part's). A pose is "
        "one line of\n"
        "12 numbers (rotation row-major, translation) or 7 (x y z qx qy qz qw). Meshes are read as stored.";
    commandLine.options.add_options()                                                               //
        ("part", optionValue("MESH"), "mesh of the moving part")                                    //
        ("environment", optionValue("MESH"), "mesh of what stands still")                           //
        ("poses", optionValue("FILE"), "the poses, one a line")                                     //
        ("query", optionValue("Q"), "distance, collide, or within=D: is the distance at most D?")   //
        ("csv", optionValue("FILE"), "writes the answers, one row a pose in the file's order")      //
        ("scale", optionValue("F"), "multiplies both meshes' coordinates, not the poses (1)")       //
        ("cap", optionValue("C"), "distances beyond C are not of interest: inf, triangles -1")      //
        ("relative-error", optionValue("E"), "the interval may be E times its lower end wide (0)")  //
        ("absolute-error", optionValue("E"), "or E wide, whichever is more (0)")                    //
        ("target", optionValue("NAME"), "instruction set, of those this machine runs (best)")       //
        ("cold", "forgets the last closest pair before every query")                                //
        ("shuffle", optionValue("SEED"), "asks in a random order; the answers' order is the file's");
    addTreeOptions(commandLine);
    addCacheOption(commandLine);
    return commandLine;
}

/// distance, collide or within=D.
void readQuestion(const Options& options, Question& question) {
    constexpr const char* kWithin = "within=";
    const std::string text = options.text("query");
    if (text == "distance") {
        question.kind = Question::Kind::kDistance;
    } else if (text == "collide") {
        question.kind = Question::Kind::kCollide;
    } else {
        const bool isWithin = text.rfind(kWithin, 0) == 0;
        const std::optional<double> d = isWithin ? parseNumber(text.substr(7)) : std::nullopt;
        if (!d || *d < 0) {
            throw std::invalid_argument(
                "--query is '" + text +
                "', expected distance, collide or within=D with a number D of at least 0");
        }
        question.kind = Question::Kind::kWithin;
        question.within = *d;
    }
}

void readDistanceOptions(const Options& options, Question& question) {
    for (const char* name : {"cap", "relative-error", "absolute-error"}) {
        if (options.has(name) && question.kind != Question::Kind::kDistance) {
            throw std::invalid_argument(std::string("--") + name + " is '" + options.text(name) +
                                        "', expected only with --query distance");
        }
    }
    DistanceOptions& distance = question.distance;
    if (options.has("cap")) distance.cap = options.nonNegative("cap");
    if (options.has("relative-error")) distance.relativeError = options.nonNegative("relative-error");
    if (options.has("absolute-error")) distance.absoluteError = options.nonNegative("absolute-error");
}

Question questionOf(const Options& options) {
    Question question;
    readQuestion(options, question);
    readDistanceOptions(options, question);
    question.isCold = options.has("cold");
    if (options.has("shuffle")) {
        question.shuffleSeed = static_cast<std::uint64_t>(options.integer("shuffle", 0, INT64_MAX));
    }
    return question;
}

void printMesh(const char* label, const Model& model) {
    printRow(label, counted(model.report().triangles, "triangle"));
    for (const std::string& note : model.origin().notes) printRow("  note", note);
}

}  // namespace

int query(const Arguments& arguments) {
    const std::optional<Options> given = parse(queryCommandLine(), arguments);
    if (!given) return kDone;
    const Options& options = *given;
    for (const char* name : {"part", "environment", "poses", "query"})
        options.text(name);  // all wrong usage first
    const Question question = questionOf(options);
    const BuildOptions tree = treeOptions(options);
    LoadOptions load;
    if (options.has("scale")) load.scale = options.positive("scale");
    if (options.has("target")) useTarget(options.text("target"));
    if (options.has("csv")) {
        requireReplaceable(options.text("csv"));
        options.requireOtherFile("csv",
                                 {options.text("part"), options.text("environment"), options.text("poses")});
    }
    const std::string cache = cacheFolder(options);

    const PoseFile poses = readPoses(options.text("poses"));
    const Model part = buildModel(guardedLoadMesh(options.text("part"), load), tree, cache);
    const Model environment = buildModel(guardedLoadMesh(options.text("environment"), load), tree, cache);
    const QueryRun run = ask(question, part, environment, poses.poses);

    printMesh("part", part);
    printMesh("environment", environment);
    printRow("trees", description(tree));
    printRow("instruction set", currentTarget());
    printRow("poses", std::to_string(poses.poses.size()) + ", " + std::to_string(poses.projected) +
                          " of them projected to the nearest rotation");
    printSummary(question, run);
    printCosts(run, part, environment);
    requirePrinted();
    if (options.has("csv")) writeCsv(question, run, options.text("csv"));
    return kDone;
}

}  // namespace clearway::cli
