// clearway check: audits a path file along its whole length.
#include <cmath>
#include <iostream>

#include "clearway/planning/check_path.h"
#include "program/cli/overlaps.h"
#include "program/cli/path_outputs.h"
#include "program/cli/print.h"
#include "program/cli/print_audit.h"
#include "program/cli/shared_options.h"

namespace clearway::cli {

namespace {

struct CheckOptions {
    ProblemChoice problem;
    TreeChoice trees;
    std::string path, csv;
    PathOutputs outputs;
};

bool readOptions(const Arguments& arguments, CheckOptions& options) {
    CommandLine line("clearway check PROBLEM.cfg IN.path [options]",
                     "Audits a path along its whole length, also between its states: how close it comes to "
                     "the environment,\n"
                     "where, between which meshes, and which of its segments are not valid.\n"
                     "Clearance is the distance less the margin; certified values are rounded down. t runs "
                     "from 0 to 1 along\n"
                     "a segment. Exit code 1 when the path is not valid or cannot be certified.");
    addProblem(line, options.problem);
    line.argument("IN.path", to(options.path));
    line.option(
        "--csv FILE",
        "writes the profile: segment, t, travel, clearance there, and clearance certified up to the next "
        "line",
        to(options.csv));
    addTarget(line);
    addPathOutputs(line, options.outputs);
    addTreeOptions(line, options.trees.options);
    addCache(line, options.trees);
    return line.parse(arguments);
}

void requireFiles(const CheckOptions& options, const Problem& problem) {
    std::vector<std::string> inputs = inputsOf(problem);
    inputs.push_back(options.path);
    OutputFiles files(inputs);
    files.add("--csv", options.csv);
    options.outputs.require(files);
}

void warnOfEnd(const char* verb, double off, double tolerance, const char* end) {
    if (off <= tolerance) return;
    printWarnings({std::string("the path ") + verb + " " + readable(off) + " from the problem's " + end +
                   ", expected at most " + readable(tolerance)});
}

void warnOfEnds(const Problem& problem, const planning::PathCheck& check) {
    warnOfEnd("begins", check.offStart, check.tolerance, "start");
    if (!problem.outside) return warnOfEnd("ends", check.offGoal, check.tolerance, "goal");
    if (check.endsAtGoal()) return;
    const auto& side = problem.outside->side;
    printWarnings({"at the path's end the part's box overlaps the environment's by " +
                   readable(check.offGoal) + (side ? " along " + nameOf(*side) : "") +
                   ", expected a goal outside"});
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
    CheckOptions options;
    if (!readOptions(arguments, options)) return kDone;
    const Problem problem = options.problem.read();
    requireFiles(options, problem);
    const std::vector<PartState> path = readPath(options.path, problem.space);
    const Scene scene = options.trees.load(problem);
    planning::PathCheck found;
    {
        const ElapsedLine elapsed("checking");
        found = planning::checkPath(problem, scene, path);
    }
    printWarnings(problem.warnings);
    warnOfEnds(problem, found);
    print(scene, found);
    if (!options.csv.empty()) writeProfile(found.audit, options.csv);
    const std::vector<FoundOverlap> overlaps = overlapsAlong(problem, scene, path);
    printOverlaps(overlaps);
    if (found.audit.isValid()) requireAllowed(overlaps);
    options.outputs.write(problem, scene, path, found.audit, {}, overlaps);
    requirePrinted();
    return found.audit.isValid() ? kDone : kAnswerIsNo;
}

}  // namespace clearway::cli
