// clearway check: a path file, audited along its whole length.
#include <cmath>
#include <iostream>
#include <stdexcept>

#include "clearway/planning/check_path.h"
#include "clearway/targets.h"
#include "core/replace_file.h"
#include "program/cli/command_line.h"
#include "program/cli/elapsed_line.h"
#include "program/cli/path_report.h"
#include "program/cli/planning_scene.h"
#include "program/cli/print.h"
#include "program/cli/print_audit.h"
#include "program/cli/tree_options.h"

namespace clearway::cli {

namespace {

CommandLine checkCommandLine() {
    CommandLine commandLine;
    commandLine.usage = "clearway check PROBLEM.cfg IN.path [options]";
    commandLine.purpose =
        "Audits a path along its whole length, between its states too: how close it comes to the "
        "environment, where, between which meshes, and which of its segments are not valid.\n"
        "Clearance is the distance less the margin; what is printed as certain is rounded down. t runs from "
        "0 to 1 along a segment.\n"
        "Exit code 1 when the path is not valid, or cannot be certified.";
    commandLine.positional = {"PROBLEM.cfg", "IN.path"};
    commandLine.options.add_options()  //
        ("csv", optionValue("FILE"),
         "writes the profile: segment, t, travel, clearance there and certain up to the next line")  //
        ("margin", optionValue("M"),
         "distance to keep from the environment, in place of the problem's margin; its margin.NAME stay")  //
        ("target", optionValue("NAME"), "instruction set, of those this machine runs (best)");
    addPathOutputs(commandLine);
    addTreeOptions(commandLine);
    addCacheOption(commandLine);
    return commandLine;
}

/// With the margin asked for. Refuses to write files that are read.
Problem readProblemFor(const Options& options) {
    Problem problem = readProblem(options.text("PROBLEM.cfg"));
    if (options.has("margin")) problem.margin = options.nonNegative("margin");
    std::vector<std::string> files = inputsOf(problem);
    files.push_back(options.text("IN.path"));
    if (options.has("csv")) {
        options.requireOtherFile("csv", files);
        files.push_back(options.text("csv"));
    }
    requirePathOutputs(options, files);
    return problem;
}

void warnOfEnd(const char* verb, double off, double tolerance, const char* end) {
    if (off <= tolerance) return;
    std::cerr << "clearway: warning: the path " << verb << " " << readable(off) << " from the problem's "
              << end << ", expected at most " << readable(tolerance) << "\n";
}

void print(const Scene& scene, const planning::PathCheck& check) {
    printMesh("part", scene.part);
    printObstacles(scene);
    printRow("length", readable(check.audit.length));
    printRow("turned", readable(check.audit.turned * 180 / M_PI) + " degrees");
    printRow("queries", std::to_string(check.audit.queries));
    printAudit(check.audit);
    std::cout << "\n";
    printSegments(check.audit);
    std::cout << "\n";
    printProfile(check.audit);
}

}  // namespace

int check(const Arguments& arguments) {
    const std::optional<Options> given = parse(checkCommandLine(), arguments);
    if (!given) return kDone;
    const Options& options = *given;
    const BuildOptions tree = treeOptions(options);
    if (options.has("margin")) options.nonNegative("margin");  // all wrong usage first
    if (options.has("target")) useTarget(options.text("target"));
    if (options.has("csv")) requireReplaceable(options.text("csv"));
    const std::string cache = cacheFolder(options);

    const Problem problem = readProblemFor(options);
    const std::vector<PartState> path = readPath(options.text("IN.path"), problem.space);
    const Scene scene = buildScene(problem, {}, tree, cache);
    planning::PathCheck found;
    {
        const ElapsedLine elapsed("checking");
        found = planning::checkPath(problem, scene, path);
    }
    printWarnings(problem.warnings);
    warnOfEnd("begins", found.offStart, found.tolerance, "start");
    warnOfEnd("ends", found.offGoal, found.tolerance, "goal");
    print(scene, found);
    if (options.has("csv")) writeProfile(found.audit, options.text("csv"));
    writePathOutputs(options, problem, scene, path, found.audit, {});
    requirePrinted();
    return found.audit.isValid() ? kDone : kAnswerIsNo;
}

}  // namespace clearway::cli
