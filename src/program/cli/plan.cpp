// clearway plan: plans a path for a problem file and writes it.
#include "clearway/planning/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <iostream>

#include "clearway/planning/check_path.h"
#include "clearway/planning/objectives.h"
#include "clearway/planning/planners.h"
#include "core/text.h"
#include "core/watch.h"
#include "program/cli/lift.h"
#include "program/cli/old_path.h"
#include "program/cli/path_outputs.h"
#include "program/cli/print_audit.h"
#include "program/cli/print_why_no_path.h"
#include "program/options/facts.h"
#include "program/options/print.h"
#include "program/options/program.h"
#include "program/options/shared_options.h"

namespace clearway::cli {

namespace {

using planning::PlanReport;

/// The error that follows on stderr says more.
constexpr const char* kRefused = "nothing was planned";

struct PlanArguments {
    ProblemChoice problem;
    planning::PlanOptions plan;
    TreeChoice trees;
    std::string path, nearest;
    std::optional<double> explainSeconds;
    PathOutputs outputs;
};

std::pair<std::string, std::string> parameterOf(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0) throw Expected{"NAME=VALUE"};
    return {text.substr(0, equals), text.substr(equals + 1)};
}

void addPlannerOptions(CommandLine& line, planning::PlanOptions& plan) {
    line.option("--planner NAME",
                "OMPL's class name, in any case, SlidingRRTConnect, TwistSearch, PlannerTeam or RisingFloor "
                "(PlannerTeam; "
                "with an objective of clearance RisingFloor or AnytimePathShortening)",
                [&](const std::string& name) { plan.planner = planning::plannerClassName(name); });
    line.option(
        "--planner-param K=V", "sets one of the planner's parameters; may be repeated",
        [&](const std::string& text) { plan.parameters.push_back(parameterOf(text)); },
        CommandLine::Count::kRepeatable);
    line.option("--objective NAME",
                "the cost that optimising planners improve until the time is up: length, max_min_clearance "
                "(the least clearance of the path), clearance_integral (length weighted by closeness), "
                "length_with_clearance, mechanical_work (the problem's objective)",
                [&](const std::string& name) { plan.objective = planning::objectiveName(name); });
    line.option("--wanted-clearance D",
                "clearance that length_with_clearance keeps where it can (5 % of the part's diagonal)",
                positive(plan.wantedClearance));
    line.option("--time S",
                "seconds in all, once the files are loaded and trees built (30); shortening takes at most as "
                "long as planning, "
                "or 5 s if that is more",
                positive(plan.seconds));
    line.option("--iterations N", "planner iterations, in place of --time: repeatable, with the same seed",
                integer<std::uint64_t>(plan.iterations, 1, INT64_MAX));
    line.exclude("--time", "--iterations");
    line.option("--threads N", "planners side by side; the first path ends them (one a core, at most 4)",
                integer<int>(plan.threads, 1, 256));
    line.option("--seed N", "seed of OMPL's random numbers (1)",
                integer<std::uint32_t>(plan.seed, 1, UINT32_MAX));
}

bool readArguments(const Arguments& arguments, PlanArguments& given) {
    CommandLine line(
        "clearway plan PROBLEM.cfg --path OUT.path [options]",
        "Finds a path from the problem's start to its goal, shortens it, audits it along its whole length "
        "and\n"
        "writes it. Ctrl-C keeps the best path so far. Exit code 1 when no path was found.");
    addProblem(line, given.problem);
    line.option("--path FILE", "where the path is written, one state a line", to(given.path),
                CommandLine::Count::kRequired);
    addPlannerOptions(line, given.plan);
    addOmplWeights(line, given.plan.omplWeights);
    line.option("--floor D", "clearance that shortening the path keeps (a thousandth of the part's diagonal)",
                nonNegative(given.plan.floor));
    line.flag("--quick",
              "leaves out the 1 to 5 seconds that give the path more clearance before it is shortened",
              given.plan.quick);
    line.exclude("--quick", "--objective");
    line.option("--nearest FILE",
                "when no path is found: writes the nearest miss as a path, of which one motion is not valid",
                to(given.nearest));
    line.option(
        "--explain S",
        "when no path is found: looks for S seconds for obstacles and margins without which there is one",
        positive(given.explainSeconds));
    addTarget(line);
    addJson(line);
    addPathOutputs(line, given.outputs);
    addTreeOptions(line, given.trees.options);
    addCache(line, given.trees);
    given.plan.isStopped = isInterrupted;
    return line.parse(arguments);
}

/// The names, each once, with its number where there are several: "2 BITstar, RRTConnect".
std::string withCounts(const std::vector<std::string>& names) {
    std::vector<std::string> texts;
    for (auto name = names.begin(); name != names.end(); ++name) {
        if (std::find(names.begin(), name, *name) != name) continue;
        const auto count = std::count(names.begin(), names.end(), *name);
        texts.push_back(count > 1 ? fmt::format("{} {}", count, *name) : *name);
    }
    return joined(texts);
}

Facts settingsFacts(const planning::PlanOptions& options, const PlanReport& report) {
    return {{"planner", fmt::format("{}, seed {}", withCounts(report.planners), options.seed), "planners",
             report.planners},
            kept("seed", options.seed),
            shownIf(options.iterations.has_value(),
                    {"repeatable",
                     report.isRepeatable ? "yes" : "no: this planner does not give the same path again"}),
            {"motions", "certified along their whole length"},
            {"floor", shownLength(report.floor)},
            {"planning time", readable(report.planningSeconds) + " s", "planning_seconds",
             toJson(report.planningSeconds)},
            {"states checked", std::to_string(report.checks), "states_checked", report.checks},
            kept("interrupted", report.isStopped),
            kept("found", !report.path.empty()),
            kept("warnings", report.warnings)};
}

std::string shownWidening(const planning::WideningReport& widening) {
    return fmt::format("{} before, {} after {} s; --objective max_min_clearance looks for more",
                       inUnit(shortened(widening.before, 2)), inUnit(shortened(widening.after, 3)),
                       readable(widening.seconds));
}

/// file: that the path is written to.
Facts pathFacts(const PlanReport& report, const std::string& file) {
    const double degrees = report.rotation * 180 / M_PI;
    Facts facts = {
        {"found by", report.foundBy, "found_by", report.foundBy},
        shownIf(!report.objective.empty(),
                {"objective", fmt::format("{}, cost {}", report.objective, readable(report.cost))}),
        shownIf(report.widening.has_value(),
                {"widening", report.widening ? shownWidening(*report.widening) : ""}),
        {"finishing time", readable(report.finishingSeconds) + " s", "finishing_seconds",
         toJson(report.finishingSeconds)},
        {"states", fmt::format("{}, {} before simplifying", report.path.size(), report.statesBefore)},
        {"length", shownLength(report.length)},
        {"rotation",
         readable(degrees) + " degrees",
         "path",
         {{"file", file},
          {"states", report.path.size()},
          {"length", toJson(report.length)},
          {"rotation_degrees", toJson(degrees)}}}};
    if (report.widening)
        facts.push_back(kept("widening", {{"before", toJson(report.widening->before)},
                                          {"after", toJson(report.widening->after)}}));
    return facts;
}

Fact proofFact(const ShutIn& shutIn) {
    const std::string inside = shutIn.isStart ? "start" : "goal", outside = shutIn.isStart ? "goal" : "start";
    return {"proof",
            fmt::format("the {} is inside '{}', a closed surface, and the {} is not", inside, shutIn.obstacle,
                        outside),
            "proof",
            {{"shut_in", inside}, {"obstacle", shutIn.obstacle}}};
}

/// A path that cannot be written after all is printed: the work is not lost.
void writeOrPrint(const std::vector<PartState>& path, Space space, const std::string& file) {
    try {
        writeOut(file, [&](std::ostream& stream) { writePath(path, space, stream); });
    } catch (const std::exception&) {
        printRow("path", "not written, its states follow");
        writePath(path, space, std::cout);
        throw;
    }
}

/// Refuses before the planning what would be refused after it.
void requireExplainable(const Scene& scene) {
    try {
        planning::requireExplainable(scene);
    } catch (const std::invalid_argument& error) {
        throw planning::RefusedOption(std::string("--explain: ") + error.what());
    }
}

planning::Explanation explain(const PlanArguments& given, const Problem& problem, ProblemScenes& scenes,
                              const planning::WhyNoPath& why) {
    planning::ExplainOptions options;
    options.plan = given.plan;
    options.seconds = *given.explainSeconds;
    options.load = [&](const Problem& changed) { return scenes.sceneWithNotes(changed, given.plan).scene; };
    const ElapsedLine elapsed("explaining");
    return planning::explain(problem, why, options);
}

/// Says why there is no path. Returns the path of a trial of --explain that solves the problem after all; empty without one.
std::vector<PartState> tellWhy(const PlanArguments& given, const planning::WhyNoPath& why,
                               const Problem& problem, ProblemScenes& scenes, const Scene& scene) {
    std::vector<PartState> path;
    printWhyNoPath(why);
    if (given.explainSeconds) {
        planning::Explanation explanation = explain(given, problem, scenes, why);
        printExplanation(explanation, scene.largestMargin());
        path = std::move(explanation.path);
    }
    if (path.empty()) {
        printHints(
            why, problem, scene,
            {given.explainSeconds.has_value(), !given.nearest.empty() || !given.outputs.report.empty()});
    }
    return path;
}

void tellNearestUnwritten(const PlanArguments& given, const std::string& why) {
    if (!given.nearest.empty()) printRow("nearest", "not written: " + why);
}

/// Why nothing was asked of planners that found no path.
std::string whyNotAsked(const PlanReport& report) {
    if (report.shutIn) return "nothing was planned, because there is no path";
    if (report.isStopped) return "planning was interrupted before there was a path";
    return report.audit.segments.empty() ? "the planner did not end in time"
                                         : "the planner's path did not pass its audit";
}

/// Without a path, the files that were asked for are about the nearest miss, or a row tells why they are not written.
void writeMiss(const PlanArguments& given, const PlanReport& report, const Problem& problem,
               const SceneMeshes& meshes, const Scene& scene, const Rows& figures) {
    PathOutputs outputs = given.outputs;
    if (!report.whyNoPath) {
        const std::string why = whyNotAsked(report);
        tellNearestUnwritten(given, why);
        if (given.explainSeconds) printRow("explained by", "nothing: " + why);
        return outputs.tellUnwritten(why);
    }
    const planning::NearestMiss& nearest = report.whyNoPath->nearest;
    if (!given.nearest.empty()) {
        writePath(nearest.path, problem.space, given.nearest);
        printRow("nearest", fmt::format("{}, segment {} is not valid", given.nearest, nearest.gap + 1));
    }
    if (!outputs.report.empty()) {
        PathOutputs page;
        std::swap(page.report, outputs.report);
        page.isOfMiss = true;
        page.write(problem, meshes, scene, nearest.path,
                   planning::checkPath(problem, scene, nearest.path).audit, figures,
                   overlapsAlong(problem, meshes, scene, nearest.path));
    }
    outputs.tellUnwritten("no path was found");
}

/// The path is as the trial's planner found it: neither widened nor shortened.
planning::PathAudit printTrialPath(const std::vector<PartState>& path, const Problem& problem,
                                   const Scene& scene, const std::string& file) {
    const planning::PathAudit audit = planning::checkPath(problem, scene, path).audit;
    printRows({{"found by", "a trial of --explain, among all obstacles; give --time more for a shorter one"},
               {"states", std::to_string(path.size())}});
    printAudit(audit, scene);
    writeOrPrint(path, problem.space, file);
    printRow("path", file);
    return audit;
}

void tellPath(const Facts& found, const PlanReport& report, const Problem& problem, const Scene& scene,
              const std::string& file) {
    tell(found);
    printAudit(report.audit, scene);
    facts()["audit"] = toJson(report.audit, scene);
    if (report.isStopped) printRow("interrupted", "the path is the best so far");
    writeOrPrint(report.path, problem.space, file);
    printRow("path", file);
}

/// Writes the files about the path; returns false when interrupted. A swept volume that is too fine for this path is
/// refused after the other files.
bool writeOutputs(PathOutputs outputs, const Problem& problem, const SceneMeshes& meshes, const Scene& scene,
                  const std::vector<PartState>& path, const planning::PathAudit& audit, const Rows& figures,
                  const std::vector<FoundOverlap>& overlaps) {
    const std::string tooFine = whySweptIsTooFine(outputs, scene, path);
    if (!tooFine.empty()) outputs.swept.clear();
    const bool isWhole = outputs.write(problem, meshes, scene, path, audit, figures, overlaps);
    if (!tooFine.empty()) throw std::invalid_argument(tooFine);
    return isWhole;
}

/// Prints and writes what was found. Tells oldPath when there is a new path.
int tellAndWrite(const PlanArguments& given, const Problem& problem, ProblemScenes& scenes,
                 const Scene& scene, PlanReport& report, OldPath& oldPath) {
    printWarnings(problem.warnings);
    printWarnings(report.warnings);
    tellScene(problem, scene);
    Facts figures = settingsFacts(given.plan, report);
    tell(figures);
    std::vector<PartState> path = report.path;
    bool isValid = false;
    if (!path.empty()) {
        // The same audit as that of `clearway check`, so that both name the same closest pair. Nobody waits for it after an interrupt.
        if (!report.isStopped) report.audit = planning::checkPath(problem, scene, path).audit;
        isValid = report.audit.isValid();
        const Facts found = pathFacts(report, given.path);
        tellPath(found, report, problem, scene, given.path);
        figures.insert(figures.end(), found.begin(), found.end());
    } else {
        printRow("path", report.shutIn          ? "none: there is none"
                         : report.isStopped     ? "none, interrupted"
                         : given.explainSeconds ? "none found so far"
                                                : "none found");
        if (report.shutIn) tell({proofFact(*report.shutIn)});
        if (report.whyNoPath) path = tellWhy(given, *report.whyNoPath, problem, scenes, scene);
        if (!path.empty()) {
            report.audit = printTrialPath(path, problem, scene, given.path);
            isValid = report.audit.isValid();
        }
    }
    if (!path.empty()) oldPath.stays();
    if (!path.empty()) tellNearestUnwritten(given, "a path was found");
    const std::vector<FoundOverlap> overlaps =
        path.empty() ? std::vector<FoundOverlap>() : overlapsAlong(problem, scenes.meshes(), scene, path);
    printOverlaps(overlaps);
    if (!report.path.empty()) facts()["overlaps"] = toJson(overlaps);
    if (isValid) requireAllowed(overlaps);
    if (path.empty()) writeMiss(given, report, problem, scenes.meshes(), scene, rowsOf(figures));
    const bool isWhole = path.empty() || writeOutputs(given.outputs, problem, scenes.meshes(), scene, path,
                                                      report.audit, rowsOf(figures), overlaps);
    requirePrinted();
    return !path.empty() && isValid && isWhole ? kDone : kAnswerIsNo;
}

std::string overrunOf(const PlanReport& report) {
    const std::string late = report.finishingSeconds > 0 ? "improving the path" : report.planners.at(0);
    return late + " did not end in time, and is ended with the program" +
           (report.path.empty() ? "" : "; the path is neither widened nor shortened");
}

/// Plans, prints and writes.
int planAndWrite(const PlanArguments& given, const Problem& problem, OldPath& oldPath) {
    // Ends the program from another thread, where this one does not come to its end.
    const auto end = [&](const std::function<int()>& tell) {
        leaveProgram("clearway", [&] {
            try {
                const int code = tell();
                return oldPath.leave(), code;
            } catch (...) {
                oldPath.leave();
                throw;
            }
        });
    };
    std::optional<ProblemScenes> scenes;
    const Scene scene = [&] {
        const Watch watch(isInterrupted, planning::kMostOverrun,
                          [&](const Watch::IsEnded&) { end(tellCutLoading); });
        scenes.emplace(problem, given.trees);
        return scenes->scene(problem, given.plan);
    }();
    if (given.explainSeconds) requireExplainable(scene);
    const std::string tooFine = whySweptIsTooFine(given.outputs, scene, {problem.start});
    if (!tooFine.empty()) throw planning::RefusedOption(tooFine);
    std::optional<ElapsedLine> elapsed;
    planning::PlanOptions options = given.plan;
    // Shrinking counts in --time; a tenth of a second is left for planning in any case.
    if (!options.iterations) {
        const double all = options.seconds.value_or(planning::kDefaultSeconds);
        options.seconds = std::max(std::min(0.1, all), all - scenes->shrinkSeconds());
    }
    options.onOverrun = [&](const PlanReport& soFar) {
        end([&] {
            elapsed.reset();
            PlanReport report = soFar;
            report.warnings.push_back(overrunOf(report));
            return tellAndWrite(given, problem, *scenes, scene, report, oldPath);
        });
    };
    elapsed.emplace("planning");
    PlanReport report;
    try {
        report = planning::plan(problem, scene, options);
    } catch (const std::exception& error) {  // the start or the goal is not valid, or an option is refused
        elapsed.reset();
        const auto* invalid = dynamic_cast<const planning::InvalidStart*>(&error);
        if (invalid != nullptr && invalid->mayOverlap) tellLiftIfAny(problem, *scenes);
        tellNearestUnwritten(given, kRefused);
        given.outputs.tellUnwritten(kRefused);
        throw;
    }
    elapsed.reset();
    return tellAndWrite(given, problem, *scenes, scene, report, oldPath);
}

}  // namespace

int plan(const Arguments& arguments) {
    PlanArguments given;
    if (!readArguments(arguments, given)) return kDone;
    heedInterrupts();
    const Problem problem = given.problem.read();
    OutputFiles files(inputsOf(problem));
    files.addOrStandardOutput("--path", given.path);
    files.add("--nearest", given.nearest);
    requireFactsFile(files);
    given.outputs.require(files);
    OldPath oldPath(given.path == "-" ? "" : given.path);
    try {
        return planAndWrite(given, problem, oldPath);
    } catch (const planning::RefusedOption&) {
        oldPath.stays();
        throw;
    }
}

}  // namespace clearway::cli
