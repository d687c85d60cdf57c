// clearway plan: from a problem file to a path file.
#include "clearway/planning/plan.h"

#include <stdexcept>

#include "clearway/planning/check_path.h"
#include "clearway/planning/objectives.h"
#include "clearway/planning/planners.h"
#include "clearway/targets.h"
#include "core/replace_file.h"
#include "program/cli/command_line.h"
#include "program/cli/elapsed_line.h"
#include "program/cli/interrupts.h"
#include "program/cli/path_report.h"
#include "program/cli/planning_scene.h"
#include "program/cli/print.h"
#include "program/cli/print_audit.h"
#include "program/cli/tree_options.h"

namespace clearway::cli {

namespace {

using planning::PlanOptions;
using planning::PlanReport;

CommandLine planCommandLine() {
    CommandLine commandLine;
    commandLine.usage = "clearway plan PROBLEM.cfg --path OUT.path [options]";
    commandLine.purpose =
        "Finds a path from the problem's start to its goal, shortens it, audits it along its whole length "
        "and writes it.\n"
        "Exit code 1 when none was found. With --step the audit may find that the path is not valid: it is "
        "written all the same, with a warning, and the exit code is 1.";
    commandLine.positional = {"PROBLEM.cfg"};
    commandLine.options.add_options()                                                 //
        ("path", optionValue("FILE"), "where the path is written, one state a line")  //
        ("planner", optionValue("NAME"),
         "OMPL's class name, in any case, or RisingFloor (RRTConnect and RRT side by side; for "
         "max_min_clearance RisingFloor)")                                                               //
        ("planner-param", optionValues("K=V"), "sets one of the planner's parameters; may be repeated")  //
        ("objective", optionValue("NAME"),
         "what planners that can go on improving a path for, until the time is up: length, "
         "max_min_clearance (the least clearance of the path), clearance_integral (length weighted by "
         "closeness), length_with_clearance, mechanical_work (the problem's)")  //
        ("wanted-clearance", optionValue("D"),
         "what length_with_clearance keeps where it can (5 % of the part's diagonal)")  //
        ("time", optionValue("S"),
         "seconds in all (30); shortening takes as many as planning at most, or 5")             //
        ("iterations", optionValue("N"), "in place of --time: repeatable, with the same seed")  //
        ("threads", optionValue("N"),
         "planners side by side, the first path ends them (one a core, at most 4)")  //
        ("seed", optionValue("N"), "of OMPL's random numbers (1)")                   //
        ("margin", optionValue("M"),
         "distance to keep from the environment, in place of the problem's margin; its margin.NAME stay")  //
        ("step", optionValue("S"),
         "checks motions at states no farther apart than this, instead of certifying them")  //
        ("floor", optionValue("D"),
         "clearance that shortening the path keeps (a thousandth of the part's diagonal)")  //
        ("ompl-weights", "rotation weighted as OMPL does, not by the part's radius")        //
        ("target", optionValue("NAME"), "instruction set, of those this machine runs (best)");
    addPathOutputs(commandLine);
    addTreeOptions(commandLine);
    addCacheOption(commandLine);
    return commandLine;
}

std::pair<std::string, std::string> parameterOf(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0) {
        throw std::invalid_argument("--planner-param is '" + text + "', expected NAME=VALUE");
    }
    return {text.substr(0, equals), text.substr(equals + 1)};
}

PlanOptions planOptions(const Options& options) {
    PlanOptions result;
    if (options.has("planner")) result.planner = planning::plannerClassName(options.text("planner"));
    for (const std::string& text : options.texts("planner-param"))
        result.parameters.push_back(parameterOf(text));
    if (options.has("objective")) result.objective = planning::objectiveName(options.text("objective"));
    if (options.has("wanted-clearance")) result.wantedClearance = options.positive("wanted-clearance");
    if (options.has("time") && options.has("iterations")) {
        throw std::invalid_argument("--time and --iterations are both given, expected one of them");
    }
    if (options.has("time")) result.seconds = options.positive("time");
    if (options.has("iterations")) {
        result.iterations = static_cast<std::uint64_t>(options.integer("iterations", 1, INT64_MAX));
    }
    if (options.has("threads")) result.threads = static_cast<int>(options.integer("threads", 1, 256));
    if (options.has("seed")) result.seed = static_cast<std::uint32_t>(options.integer("seed", 1, UINT32_MAX));
    if (options.has("step")) result.step = options.positive("step");
    if (options.has("floor")) result.floor = options.nonNegative("floor");
    if (result.step && result.floor) {
        throw std::invalid_argument("--step and --floor are both given, expected one of them");
    }
    result.omplWeights = options.has("ompl-weights");
    result.isStopped = isInterrupted;
    return result;
}

/// With the margin asked for. Refuses a path that would replace what is read.
Problem readProblemFor(const Options& options) {
    Problem problem = readProblem(options.text("PROBLEM.cfg"));
    if (options.has("margin")) problem.margin = options.nonNegative("margin");
    std::vector<std::string> files = inputsOf(problem);
    options.requireOtherFile("path", files);
    files.push_back(options.text("path"));
    requirePathOutputs(options, files);
    return problem;
}

Rows settingsRows(const PlanOptions& options, const PlanReport& report) {
    std::string planners;
    for (const std::string& name : report.planners) planners += (planners.empty() ? "" : ", ") + name;
    Rows rows = {{"planner", planners + ", seed " + std::to_string(options.seed)}};
    if (options.iterations) {
        rows.push_back({"repeatable",
                        report.isRepeatable ? "yes" : "no: this planner does not give the same path again"});
    }
    rows.push_back({"motions", report.isCertified ? "certified along their whole length"
                                                  : "checked every " + readable(report.step)});
    if (report.isCertified) rows.push_back({"floor", readable(report.floor)});
    if (report.guard > 0)
        rows.push_back(
            {"kept on top", readable(report.guard) + ", so that states between checks are valid too"});
    rows.push_back({"planning time", readable(report.planningSeconds) + " s"});
    rows.push_back({"states checked", std::to_string(report.checks)});
    return rows;
}

Rows pathRows(const PlanReport& report) {
    Rows rows = {{"found by", report.foundBy}};
    if (!report.objective.empty()) {
        rows.push_back({"objective", report.objective + ", cost " + readable(report.cost)});
    }
    rows.push_back({"finishing time", readable(report.finishingSeconds) + " s"});
    rows.push_back({"states", std::to_string(report.path.size()) + ", " +
                                  std::to_string(report.statesBefore) + " before simplifying"});
    rows.push_back({"length", readable(report.length)});
    rows.push_back({"turned", readable(report.turned * 180 / M_PI) + " degrees"});
    return rows;
}

/// The path is audited again, for a profile of what is certified: planning itself has no use for it.
void writeOutputs(const Options& options, const Problem& problem, const Scene& scene,
                  const PlanReport& report, Rows figures) {
    if (!options.has("report") && !options.has("export")) return;
    for (const auto& row : pathRows(report)) figures.push_back(row);
    const planning::PathCheck checked = planning::checkPath(problem, scene, report.path);
    writePathOutputs(options, problem, scene, report.path, checked.audit, figures);
}

void printOutcome(const PlanReport& report, const Problem& problem, const std::string& file) {
    if (report.outcome == PlanReport::Outcome::kFound) {
        printRows(pathRows(report));
        printAudit(report.audit);
        writePath(report.path, problem.space, file);
        printRow("path", file);
    } else {
        printRow("path",
                 report.outcome == PlanReport::Outcome::kStopped ? "none, interrupted" : "none found");
    }
}

}  // namespace

int plan(const Arguments& arguments) {
    const std::optional<Options> given = parse(planCommandLine(), arguments);
    if (!given) return kDone;
    const Options& options = *given;
    const std::string file = options.text("path");
    const PlanOptions planOptionsGiven = planOptions(options);
    const BuildOptions tree = treeOptions(options);
    if (options.has("margin")) options.nonNegative("margin");  // all wrong usage first
    if (options.has("target")) useTarget(options.text("target"));
    requireReplaceable(file);
    const std::string cache = cacheFolder(options);
    heedInterrupts();

    const Problem problem = readProblemFor(options);
    const Scene scene = buildScene(problem, planOptionsGiven, tree, cache);
    PlanReport report;
    {
        const ElapsedLine elapsed("planning");
        report = planning::plan(problem, scene, planOptionsGiven);
    }
    printWarnings(problem.warnings);
    printWarnings(report.warnings);
    printMesh("part", scene.part);
    printObstacles(scene);
    const Rows settings = settingsRows(planOptionsGiven, report);
    printRows(settings);
    printOutcome(report, problem, file);
    const bool isFound = report.outcome == PlanReport::Outcome::kFound;
    if (isFound) writeOutputs(options, problem, scene, report, settings);
    requirePrinted();
    return isFound && report.audit.isValid() ? kDone : kAnswerIsNo;
}

}  // namespace clearway::cli
