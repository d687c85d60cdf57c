// clearway info: shows the content of a mesh or a problem, the conversions on reading, and the trees built.
#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/predicate.hpp>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <optional>
#include <stdexcept>

#include "clearway/planning/plan.h"
#include "clearway/problem.h"
#include "clearway/scene_clearance.h"
#include "core/clock.h"
#include "core/number.h"
#include "mesh/clean.h"
#include "mesh/components.h"
#include "mesh/topology.h"
#include "model/obstacle_names.h"
#include "problem/clearance_word.h"
#include "program/cli/assembly.h"
#include "program/cli/enclosure.h"
#include "program/cli/lift.h"
#include "program/cli/mesh_facts.h"
#include "program/cli/overlaps.h"
#include "program/cli/path_outputs.h"
#include "program/cli/print_audit.h"
#include "program/options/facts.h"
#include "program/options/load_guard.h"
#include "program/options/print.h"
#include "program/options/shared_options.h"

namespace clearway::cli {

namespace {

std::string goalOf(const Problem& problem) {
    if (!problem.outside) return shownState(problem.goal);
    const auto& side = problem.outside->side;
    return side ? "outside, beyond " + nameOf(*side) + " of the environment's box"
                : "outside of the environment's box";
}

std::string boundsNote(const Problem& problem) {
    if (problem.volume) return "";
    return std::string(" (the environment's box, grown to hold ") +
           (problem.outside ? "the start and the part outside)" : "start and goal)");
}

std::string description(const PlannerChoice& planner) {
    std::string text = planner.name;
    for (const auto& [name, value] : planner.parameters) text += ", " + name + " = " + value;
    for (const auto& [name, value] : planner.settings) text += ", problem." + name + " = " + value;
    return text;
}

Json namedValues(const NamedTexts& texts) {
    Json json = Json::object();
    for (const auto& [name, value] : texts) json[name] = value;
    return json;
}

Fact contactFact(const std::string& where, const std::optional<ContactRule>& contact) {
    const std::string name = "contact_" + where;
    if (!contact) return kept(name, nullptr);
    return {"contact at " + where,
            statedLength(contact->distance),
            name,
            {{"obstacles", contact->names}, {"distance", toJson(contact->distance)}}};
}

/// Tells all of the problem but its meshes. environmentBox: bounds the part's position where the problem
/// states no volume. partBox: the part's, in its own coordinates. Throws as boundsOf does.
void describeProblem(const Problem& problem, const Box& environmentBox, const Box& partBox) {
    const Box bounds = boundsOf(problem, environmentBox, partBox);
    const std::string space = problem.space == Space::kSe3 ? "SE(3)" : "SE(2)";
    const std::string& name = problem.name;
    const auto& threshold = problem.planning.objectiveThreshold;
    tellProblem(problem);
    tell({{"problem", problem.file + (name.empty() ? "" : " (" + name + ")"), "name", name},
          {"space", space, "space", space},
          {"start", shownState(problem.start), "start", toJson(problem.start)},
          {"goal", goalOf(problem), "goal", problem.outside ? Json("outside") : toJson(problem.goal)},
          {"bounds", inUnit(readable(bounds)) + boundsNote(problem), "bounds", toJson(bounds)},
          kept("bounds_stated", problem.volume.has_value()),
          {"objective", problem.planning.objective + (threshold ? ", threshold " + readable(*threshold) : ""),
           "objective", problem.planning.objective},
          kept("objective_threshold", threshold ? Json(*threshold) : Json()),
          shownIf(!problem.planning.sampler.empty(),
                  {"sampler", problem.planning.sampler, "sampler", problem.planning.sampler}),
          optionalFact("goal threshold", "goal_threshold", problem.planning.goalThreshold),
          kept("settings", namedValues(problem.planning.settings))});
    for (const auto& [setting, value] : problem.planning.settings)
        printRow("setting", setting + " = " + value);
    const std::size_t planners = problem.planning.planners.size();
    tell({{"margin", statedLength(problem.margin), "margin", toJson(problem.margin)},
          {"unit", problem.unit.empty() ? "not stated" : problem.unit},
          contactFact("start", problem.rules.startContact),
          contactFact("goal", problem.rules.goalContact),
          {"fineness", problem.fineness ? statedLength(*problem.fineness) : "not stated", "fineness",
           problem.fineness ? Json(*problem.fineness) : Json()},
          kept("coordinates", problem.meshes.asOmplApp ? "omplapp" : "stored"),
          {"planners", planners == 0 ? "not stated" : std::to_string(planners), "planners", Json::array()}});
    for (const PlannerChoice& planner : problem.planning.planners) {
        printRow("  planner", description(planner));
        facts()["planners"].push_back({{"name", planner.name},
                                       {"parameters", namedValues(planner.parameters)},
                                       {"settings", namedValues(planner.settings)}});
    }
    tell({optionalFact("time limit", "time_limit_seconds", problem.benchmark.timeLimit, "s"),
          optionalFact("memory limit", "memory_limit_megabytes", problem.benchmark.memoryLimit, "MB"),
          optionalFact("runs", "runs", problem.benchmark.runCount),
          shownIf(!problem.benchmark.outputFolder.empty(), {"log folder", problem.benchmark.outputFolder}),
          kept("warnings", problem.warnings)});
    for (const std::string& warning : problem.warnings) printRow("warning", warning);
    if (problem.outside && problem.outside->side) facts()["outside"] = nameOf(*problem.outside->side);
}

/// Tells whether the part is valid at an end of the path ("start", "goal"); if so, how far from what; if not, why. Returns why.
WhyInvalid::Kind describeEnd(const std::string& end, const SceneClearance& clearance, const PartState& state,
                             EnclosureNotes& enclosures) {
    const std::string label = "at the " + end;
    const Pose X_environmentPart = poseOf(state);
    const PoseClearance at = clearance.at(X_environmentPart);
    const WhyInvalid why = clearance.whyInvalid(X_environmentPart, at);
    const MeshNames names = distinctMeshNames(clearance.scene(), at.nearest);
    const std::string word = clearanceWord(clearance.scene());
    tell({{label,
           !why.isValid()         ? "NOT valid: " + why.words()
           : std::isinf(at.lower) ? "valid, with nothing near"
           : !at.nearest.witness
               ? fmt::format("valid, {} {} or more{}", word, shownLength(at.lower), leftOutAt(at))
               : fmt::format("valid, {} {}{}, between '{}' and '{}'{}", word, shownLength(at.lower),
                             slackLimit(clearance.scene(), at.nearest), names.part, names.environment,
                             leftOutAt(at)),
           "at_" + end,
           {{"valid", why.isValid()},
            {"kind", nameOf(why.kind)},
            {"why_not", why.isValid() ? Json() : Json(why.words())},
            {word, toJson(at.lower)},
            {"pair", closestPair(at.nearest, names.part, names.environment)}}}});
    const std::string note = enclosures.at(X_environmentPart);
    if (!note.empty()) printWarnings({label + " " + note});
    return why.kind;
}

/// Tells how far the part must be moved along each axis to come free, the shortest way first.
void tellEscapes(const Problem& problem, ProblemScenes& scenes) {
    const SceneClearance clearance(scenes.wholeScene(problem));
    const int axes = problem.space == Space::kSe2 ? 2 : 3;
    std::vector<std::pair<EscapeDistance, std::string>> ways;
    for (int axis = 0; axis < axes; ++axis) {
        for (const double sign : {1.0, -1.0}) {
            const EscapeDistance found =
                clearance.escapeDistance(poseOf(problem.start), sign * Vector3::Unit(axis));
            ways.emplace_back(found, std::string(sign > 0 ? "+" : "-") + "xyz"[axis]);
        }
    }
    std::stable_sort(ways.begin(), ways.end(),
                     [](const auto& a, const auto& b) { return a.first.upper < b.first.upper; });
    Fact fact{"comes free", "", "escapes", Json::array()};
    for (const auto& [way, direction] : ways) {
        fact.shown += (fact.shown.empty() ? "" : ", ") + direction + " " + shownLength(way.upper);
        fact.value.push_back(
            {{"direction", direction}, {"lower", toJson(way.lower)}, {"upper", toJson(way.upper)}});
    }
    fact.shown = "pushed through its obstacles by " + fact.shown;
    tell({fact});
}

struct DescribedEnds {
    Model part;
    bool collidesAtStart;
};

DescribedEnds describeEnds(const Problem& problem, ProblemScenes& scenes) {
    const LoadedScene loaded = scenes.sceneWithNotes(problem);
    printWarnings(loaded.notes);
    facts()["notes"] = loaded.notes;
    const SceneClearance clearance(loaded.scene);
    EnclosureNotes enclosures(problem, scenes.meshes());
    const WhyInvalid::Kind atStart = describeEnd("start", clearance, problem.start, enclosures);
    using Kind = WhyInvalid::Kind;
    if (atStart == Kind::kCollides || atStart == Kind::kTooDeep || atStart == Kind::kInSolid ||
        atStart == Kind::kTooClose)
        tellEscapes(problem, scenes);
    if (!problem.outside) describeEnd("goal", clearance, problem.goal, enclosures);
    printRows(deflectionRows());
    return {loaded.scene.part, atStart == WhyInvalid::Kind::kCollides};
}

void describeProblemFile(const std::string& file, const BuildOptions& tree) {
    const Problem problem = readJudged(file);
    ProblemScenes scenes(problem, {tree, ""});
    const Mesh& part = scenes.meshes().part;
    Problem alike = problem;
    alike.rules = {};
    const Mesh environment = shownEnvironment(alike, scenes.meshes().worlds);  // without what moves
    describeProblem(problem, boundingBox(environment), boundingBox(part));
    tellObstacles(obstaclesOf(problem, scenes.meshes().worlds));
    const auto [partModel, collidesAtStart] = describeEnds(problem, scenes);
    std::cout << "\nPart\n";
    describeMesh("part", part, problem.meshes.asOmplApp ? "as OMPL.app reads a robot" : "as stored",
                 partModel);
    std::cout << "\nEnvironment\n";
    const auto range = planning::planningRange(problem, {}, partModel, boundingBox(environment));
    describeMesh("environment", environment,
                 problem.meshes.asOmplApp ? "as OMPL.app reads its world" : "as stored",
                 scenes.modelOf(environment, range), range);
    if (collidesAtStart) tellLiftIfAny(problem, scenes);
}

/// Says how deep obstacles reach into the part at the start, and which overlaps free the start.
void describeLift(const std::string& file) {
    Problem problem = readJudged(file);
    tellProblem(problem);
    ProblemScenes scenes(problem, {});
    const std::vector<FoundOverlap> overlaps = overlapsAtStart(problem, scenes.meshes());
    facts()["overlaps"] = toJson(overlaps);
    for (const FoundOverlap& found : overlaps) printRow(found.obstacle, describe(found));
    if (overlaps.empty()) printRow("start", "neither part nor obstacles reach into the other");
    if (const std::optional<Lift> lift = findLift(problem, scenes, overlaps, true)) {
        tell(*lift);
    } else if (!overlaps.empty()) {
        printRow("start", "no surfaces touch");
    }
}

}  // namespace

constexpr double kWidestGap = 1e-3;         ///< of an assembly's diagonal: wider gaps are not shown
constexpr std::size_t kMostOpenNamed = 12;  ///< on screen

/// Tells which parts are open: they hold nothing, and have no depth that others could reach to.
void tellOpenParts(const Mesh& assembly) {
    const std::vector<Component> components = componentsOf(assembly);
    std::vector<std::string> open;
    for (std::size_t i = 0; i < components.size(); ++i) {
        if (components[i].triangleCount > 0 &&
            !checkEdges(clean(meshOfComponents(assembly, {i})).triangles).isClosed())
            open.push_back(components[i].name);
    }
    tell({shownIf(!open.empty(),
                  {"open parts",
                   fmt::format("{} of {}: {}", open.size(), components.size(), listed(open, kMostOpenNamed)),
                   "open_parts", open})});
}

/// Tells which parts of an assembly touch each other, reach into each other, or are near.
void describePairs(const Mesh& assembly, const std::optional<double>& near, const std::string& csv,
                   const std::string& picture) {
    const double widest = near.value_or(kWidestGap * boundingBox(assembly).diagonal().norm());
    std::cout << "\nPairs of parts\n";
    tellDeflection(deflectionOf(assembly));
    printRows(deflectionRows());
    if (componentsOf(assembly).size() < 2) {
        if (!csv.empty() || !picture.empty())
            throw std::invalid_argument("--csv and --picture are of several parts, and there is one alone");
        return printRow("parts", "one alone: there is nothing to compare");
    }
    const auto begin = Clock::now();
    std::optional<ElapsedLine> elapsed("comparing parts");
    const std::vector<PartPair> pairs = pairsOf(assembly, widest);
    elapsed.reset();
    facts()["pairs_seconds"] = secondsSince(begin);
    tellPairs(pairs, widest, csv);
    tellOpenParts(assembly);
    if (!picture.empty()) drawPairs(assembly, pairs, picture);
}

int info(const Arguments& arguments) {
    std::string file, csv, picture;
    std::optional<double> scale, near;
    BuildOptions tree;
    bool isLift = false, arePairs = false;
    CommandLine line(
        "clearway info MESH|FOLDER|PROBLEM.cfg [options]",
        "Shows what a mesh or a problem's two meshes hold: triangles, components, box, whether the\n"
        "surface is closed, the conversions on reading, the findings of cleaning, and the tree built.\n"
        "Of an assembly, a mesh of several components or a folder of mesh files, --pairs shows which parts\n"
        "touch each other, reach into each other, or are near.");
    line.argument("MESH|FOLDER|PROBLEM.cfg", to(file));
    line.flag("--pairs", "tells what touches what; a folder implies it", arePairs);
    line.option("--near D", "widest gap of a pair (a thousandth of the assembly's diagonal)",
                nonNegative(near));
    line.option("--csv FILE", "writes the pairs as a table", to(csv));
    line.option("--picture FILE", "draws the assembly, .png, with a ring around each contact and overlap",
                to(picture));
    line.option("--scale F", "factor for the coordinates of a mesh file (1)", positive(scale));
    line.flag(
        "--lift",
        "tells how deep obstacles reach into the part at the problem's start, and the least overlap that "
        "frees it",
        isLift);
    addJson(line);
    addTreeOptions(line, tree);
    if (!line.parse(arguments)) return kDone;
    OutputFiles files({file});
    files.add("--csv", csv, {".csv"});
    files.add("--picture", picture, {".png"});
    requireFactsFile(files);
    const bool isFolder = std::filesystem::is_directory(file);
    arePairs = arePairs || isFolder || near || !csv.empty() || !picture.empty();
    if (arePairs && boost::iends_with(file, ".cfg") && !isFolder)
        throw std::invalid_argument("--pairs, --near, --csv and --picture are about assemblies, and '" +
                                    file +
                                    "' is a problem, expected a mesh of several components or a folder");

    if (isFolder) {
        if (scale)
            throw std::invalid_argument("--scale is given with the folder '" + file + "', expected a mesh");
        if (isLift)
            throw std::invalid_argument("--lift is given with the folder '" + file + "', expected a problem");
        const Mesh assembly = loadAssembly(file, guardedLoadMesh);
        printWarnings(assembly.origin.warnings);
        tell({{"assembly",
               fmt::format("{}, {}, {}", file, counted(assembly.components.size(), "part"),
                           counted(assembly.triangles.size(), "triangle")),
               "assembly",
               {{"folder", file}, {"components", toJson(assembly.components)}}}});
        describePairs(assembly, near, csv, picture);
    } else if (!boost::iends_with(file, ".cfg")) {
        if (isLift)
            throw std::invalid_argument("--lift is given with the mesh '" + file + "', expected a problem");
        LoadOptions load;
        load.scale = scale.value_or(1);
        const Mesh mesh = guardedLoadMesh(file, load);
        describeMesh("mesh", mesh, "as stored", Model::build(mesh, tree));
        if (arePairs) describePairs(mesh, near, csv, picture);
    } else if (scale) {
        throw std::invalid_argument(
            "--scale is '" + readable(*scale) +
            "', expected only with a mesh: a problem file says how its meshes are read");
    } else if (isLift) {
        describeLift(file);
    } else {
        describeProblemFile(file, tree);
    }
    return kDone;
}

}  // namespace clearway::cli
