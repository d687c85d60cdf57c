// clearway check: audits a path file along its whole length.
#include <fmt/format.h>

#include <cmath>
#include <iostream>
#include <stdexcept>

#include "clearway/planning/check_path.h"
#include "program/cli/overlaps.h"
#include "program/cli/path_outputs.h"
#include "program/cli/print_audit.h"
#include "program/options/facts.h"
#include "program/options/print.h"
#include "program/options/shared_options.h"

namespace clearway::cli {

namespace {

struct CheckOptions {
    ProblemChoice problem;
    TreeChoice trees;
    std::string path, csv;
    bool isAnyEnds = false, isBrief = false;
    PathOutputs outputs;
};

bool readOptions(const Arguments& arguments, CheckOptions& options) {
    CommandLine line("clearway check PROBLEM.cfg IN.path [options]",
                     "Audits a path along its whole length, also between its states: how close it comes to "
                     "the environment,\n"
                     "where, between which meshes, and which of its segments are not valid.\n"
                     "Clearance is the distance less the margin; certified values are rounded down. t runs "
                     "from 0 to 1 along\n"
                     "a segment. Bounds that the problem does not state hold the path too. Exit code 1 when "
                     "the path is not valid,\n"
                     "cannot be certified, or misses the problem's start or goal.");
    addProblem(line, options.problem);
    line.argument("IN.path", input(options.path));
    line.option("--csv FILE",
                "writes the profile: segment, t, travel, clearance there, clearance certified up to the next "
                "line, pose, "
                "and the closest points with their triangles",
                to(options.csv));
    line.flag("--any-ends", "accepts a path that begins or ends elsewhere than the problem",
              options.isAnyEnds);
    line.flag("--brief", "leaves out the table of segments and the plot of the clearance", options.isBrief);
    addTarget(line);
    addJson(line);
    addPathOutputs(line, options.outputs);
    addTreeOptions(line, options.trees.options);
    addCache(line, options.trees);
    return line.parse(arguments);
}

void requireFiles(const CheckOptions& options, const Problem& problem) {
    std::vector<std::string> inputs = inputsOf(problem);
    inputs.push_back(options.path);
    OutputFiles files(inputs);
    files.addOrStandardOutput("--csv", options.csv);
    requireFactsFile(files);
    options.outputs.require(files);
}

/// Says where the path begins and ends, if it misses the problem's start or goal. isAnyEnds: it may miss them.
void printEnds(const Problem& problem, const planning::PathCheck& check, bool isAnyEnds) {
    const auto print = [&](const char* label, const std::string& place, const std::string& expected) {
        printRow(label, place + (isAnyEnds ? "" : ", expected " + expected));
    };
    const std::string most = "at most " + shownLength(check.tolerance);
    if (!check.beginsAtStart())
        print("begins", shownLength(check.offStart) + " from the problem's start", most);
    if (check.endsAtGoal()) return;
    if (!problem.outside) {
        print("ends", shownLength(check.offGoal) + " from the problem's goal", most);
        return;
    }
    const auto& side = problem.outside->side;
    print("ends",
          "where the part's box overlaps the environment's by " + shownLength(check.offGoal) +
              (side ? " along " + nameOf(*side) : ""),
          "a goal outside");
}

/// How much of the path's length is known to be valid. Turning counts by the way of the part's furthest point.
double validShare(const Scene& scene, const planning::PathAudit& audit) {
    double valid = 0, all = 0;
    for (const planning::SegmentAudit& segment : audit.segments) {
        const double length = segment.length + segment.rotation * scene.part.radiusAboutOrigin();
        all += length;
        valid += length * (segment.isValid() ? 1 : segment.motion.certifiedTime);
    }
    return all > 0 ? valid / all : audit.isValid();
}

/// Prints the check, and keeps its facts.
void tellCheck(const Problem& problem, const Scene& scene, const planning::PathCheck& check,
               const CheckOptions& options) {
    const planning::PathAudit& audit = check.audit;
    const double share = validShare(scene, audit);
    tellScene(problem, scene);
    printRows({{"length", shownLength(audit.length)},
               {"rotation", readable(audit.rotation * 180 / M_PI) + " degrees"},
               {"queries", std::to_string(audit.queries)}});
    printAudit(audit, scene);
    facts()["audit"] = toJson(audit, scene);
    tell({shownIf(!audit.isValid(),
                  {"valid",
                   fmt::format("at least {} % of the length: each segment counts up to where it is not valid",
                               shortened(100 * share)),
                   "valid_share", toJson(share)}),
          kept("off_start", toJson(check.offStart)), kept("off_goal", toJson(check.offGoal)),
          kept("ends_tolerance", toJson(check.tolerance))});
    printEnds(problem, check, options.isAnyEnds);
    if (options.isBrief) return;
    std::cout << "\n";
    printSegments(audit, scene);
    std::cout << "\n";
    printProfile(audit, scene);
}

}  // namespace

int check(const Arguments& arguments) {
    CheckOptions options;
    if (!readOptions(arguments, options)) return kDone;
    Problem problem = options.problem.read();
    requireFiles(options, problem);
    const std::vector<PartState> path = readPath(options.path, problem.space);
    for (const PartState& state : path) problem.knownPath.extend(state.position);
    ProblemScenes scenes(problem, options.trees);
    const Scene scene = scenes.scene(problem);
    const std::string tooFine = whySweptIsTooFine(options.outputs, scene, path);
    if (!tooFine.empty()) throw std::invalid_argument(tooFine);
    planning::PathCheck found;
    {
        const ElapsedLine elapsed("checking");
        found = planning::checkPath(problem, scene, path);
    }
    printWarnings(problem.warnings);
    tellCheck(problem, scene, found, options);
    if (!options.csv.empty()) writeProfile(found.audit, scene, path, options.csv);
    const std::vector<FoundOverlap> overlaps = overlapsAlong(problem, scenes.meshes(), scene, path);
    printOverlaps(overlaps);
    facts()["overlaps"] = toJson(overlaps);
    if (found.audit.isValid()) requireAllowed(overlaps);
    const bool isWhole =
        options.outputs.write(problem, scenes.meshes(), scene, path, found.audit, {}, overlaps);
    requirePrinted();
    const bool hasEnds = options.isAnyEnds || (found.beginsAtStart() && found.endsAtGoal());
    return found.audit.isValid() && hasEnds && isWhole ? kDone : kAnswerIsNo;
}

}  // namespace clearway::cli
