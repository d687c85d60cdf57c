// clearway info: shows the content of a mesh or a problem, the conversions on reading, and the trees built.
#include <boost/algorithm/string/predicate.hpp>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "clearway/planning/plan.h"
#include "clearway/problem.h"
#include "clearway/scene_clearance.h"
#include "core/number.h"
#include "mesh/check.h"
#include "mesh/clean.h"
#include "mesh/topology.h"
#include "program/cli/enclosure.h"
#include "program/cli/info_facts.h"
#include "program/cli/overlaps.h"
#include "program/cli/print_audit.h"
#include "program/options/load_guard.h"
#include "program/options/print.h"
#include "program/options/shared_options.h"

namespace clearway::cli {

namespace {

constexpr int kMostDoublings = 8;
constexpr double kLiftError = 0.02;     ///< of the least overlap that frees a start
constexpr double kSmallLift = 1e-3;     ///< of the diagonal of a part that is only touched
constexpr double kLiftTolerance = 0.5;  ///< of the overlap, unless the problem states one

Box inFileUnits(const Box& box, const MeshOrigin& origin) {
    return Box((box.min() - origin.shift) / origin.scale, (box.max() - origin.shift) / origin.scale);
}

void describeReading(const Mesh& mesh, const std::string& reading) {
    const MeshOrigin& origin = mesh.origin;
    const Box box = boundingBox(mesh);
    printRow("mesh", origin.file);
    printRow("read", reading);
    for (const auto& [label, text] : readingRows(origin)) printRow(label, text);
    printRow("applied", "scale " + readable(origin.scale) + ", then shift " + readable(origin.shift));
    if (origin.ignoredFaces > 0) {
        printRow("left out", counted(origin.ignoredFaces, "face") +
                                 " (points, lines, and triangles of faces whose outlines cross themselves)");
    }
    printRow("box in file units", readable(inFileUnits(box, origin)));
    printRow("box as applied", inUnit(readable(box)));
    printRow("size as applied", shownPlace(box.sizes()));
}

void describeTriangles(const Mesh& mesh, const CleanMesh& cleaned) {
    printRow("triangles", std::to_string(mesh.triangles.size()));
    printRow("vertices", std::to_string(mesh.vertices.size()) + " read, " +
                             std::to_string(cleaned.vertices.size()) + " different ones in use");
    printRow("components", std::to_string(mesh.components.size()));
    for (const Component& component : mesh.components) {
        printRow("  " + component.name, counted(component.triangleCount, "triangle"));
    }
    const EdgeReport edges = checkEdges(cleaned.triangles);
    std::string surface = "closed";
    if (edges.closedEdges == 0 && edges.isClosed()) {
        surface = "none: every triangle is a point or a line";
    } else if (edges.isClosed() && edges.touchingEdges > 0) {
        surface += ", and touches itself along " + counted(edges.touchingEdges, "edge");
    } else if (!edges.isClosed()) {
        surface = "open: " + counted(edges.openEdges, "edge") + " of one triangle, " +
                  std::to_string(edges.touchingEdges + edges.overfullEdges) + " of more than two, " +
                  std::to_string(edges.twistedEdges) + " where the two neighbours face different sides";
    }
    printRow("surface", surface);
    const CleanReport& report = cleaned.report;
    printRow("cleaning", counted(report.weldedVertices, "vertex copy", "vertex copies") + " welded, " +
                             std::to_string(report.unusedVertices) + " unused, " +
                             counted(report.degenerateTriangles, "triangle") + " without area kept, " +
                             counted(report.duplicateTriangles, "duplicate") + " dropped");
}

void describeReach(const Reach& reach, const BuildReport& report) {
    printRow("out of reach", counted(report.unreachableTriangles, "triangle") + ", never within " +
                                 shownLength(reach.cap) + " of the part; planning leaves them out");
}

void describeTree(const BuildReport& report) {
    const TreeStatistics& tree = report.tree;
    std::string leaves = std::to_string(tree.leaves);
    for (std::size_t size = 1; size < tree.leavesBySize.size(); ++size) {
        leaves += (size == 1 ? ": " : ", ") + std::to_string(tree.leavesBySize[size]) + " of " +
                  std::to_string(size);
    }
    printRow("tree", treeDescription(report.options));
    printRow("  nodes",
             std::to_string(tree.nodes) + ", " + readable(tree.meanChildren) + " children on average");
    printRow("  leaves", leaves);
    printRow("  depth", std::to_string(tree.depth));
    printRow("  bytes",
             std::to_string(tree.bytes) + ", " +
                 readable(static_cast<double>(tree.bytes) / static_cast<double>(report.triangles)) +
                 " per triangle");
    printRow("  build seconds", readable(report.seconds));
}

/// Prints the file and the conversions on reading, the box, whether the surface is closed, the findings of
/// cleaning, and the tree. reading: how the file was read, in words. With a reach, the tree leaves out the
/// triangles beyond it and a row counts them. name: of the mesh among the facts.
Model describeMesh(const char* name, const Mesh& mesh, const std::string& reading,
                   const BuildOptions& options, const std::optional<Reach>& reach = std::nullopt) {
    describeReading(mesh, reading);
    const CleanMesh cleaned = clean(mesh);
    describeTriangles(mesh, cleaned);
    const Model model = Model::build(mesh, options, reach);
    facts()[name] = meshFacts(mesh, cleaned, model);
    if (reach) describeReach(*reach, model.report());
    describeTree(model.report());
    return model;
}

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

void printContact(const char* where, const std::optional<ContactRule>& contact) {
    if (contact) printRow(where, statedLength(contact->distance));
}

/// Prints all of the problem but its meshes. environmentBox: bounds the part's position where the problem
/// states no volume. partBox: the part's, in its own coordinates. Throws as boundsOf does.
void describeProblem(const Problem& problem, const Box& environmentBox, const Box& partBox) {
    const Box bounds = boundsOf(problem, environmentBox, partBox);
    tellProblem(problem);
    facts().update(problemFacts(problem, bounds));
    printRow("problem", problem.file + (problem.name.empty() ? "" : " (" + problem.name + ")"));
    printRow("space", problem.space == Space::kSe3 ? "SE(3)" : "SE(2)");
    printRow("start", shownState(problem.start));
    printRow("goal", goalOf(problem));
    printRow("bounds", inUnit(readable(bounds)) + boundsNote(problem));
    printRow("objective", problem.planning.objective +
                              (problem.planning.objectiveThreshold
                                   ? ", threshold " + readable(*problem.planning.objectiveThreshold)
                                   : std::string()));
    if (!problem.planning.sampler.empty()) printRow("sampler", problem.planning.sampler);
    if (problem.planning.goalThreshold) printRow("goal threshold", readable(*problem.planning.goalThreshold));
    for (const auto& [name, value] : problem.planning.settings) printRow("setting", name + " = " + value);
    printRow("margin", statedLength(problem.margin));
    printRow("unit", problem.unit.empty() ? "not stated" : problem.unit);
    printContact("contact at start", problem.rules.startContact);
    printContact("contact at goal", problem.rules.goalContact);
    printRow("fineness", problem.fineness ? statedLength(*problem.fineness) : "not stated");
    printRow("planners", problem.planning.planners.empty()
                             ? "not stated"
                             : std::to_string(problem.planning.planners.size()));
    for (const PlannerChoice& planner : problem.planning.planners)
        printRow("  planner", description(planner));
    if (problem.benchmark.timeLimit) printRow("time limit", readable(*problem.benchmark.timeLimit) + " s");
    if (problem.benchmark.memoryLimit)
        printRow("memory limit", readable(*problem.benchmark.memoryLimit) + " MB");
    if (problem.benchmark.runCount) printRow("runs", std::to_string(*problem.benchmark.runCount));
    if (!problem.benchmark.outputFolder.empty()) printRow("log folder", problem.benchmark.outputFolder);
    for (const std::string& warning : problem.warnings) printRow("warning", warning);
}

/// Says whether the part is valid at a pose, and how far it is from what.
void describePose(const char* label, const SceneClearance& clearance, const PartState& state,
                  const Mesh& part, const std::vector<Mesh>& worlds) {
    const Pose X_environmentPart = poseOf(state);
    const PoseClearance at = clearance.at(X_environmentPart);
    const WhyInvalid why = clearance.whyInvalid(X_environmentPart, at);
    if (!why.isValid()) return printRow(label, "NOT valid: " + why.words());
    const auto& obstacles = clearance.scene().obstacles;
    const bool mayTouch = clearance.distance(X_environmentPart).collides() ||
                          std::any_of(obstacles.begin(), obstacles.end(),
                                      [](const Obstacle& obstacle) { return obstacle.shrunk != nullptr; });
    const std::string note = mayTouch ? "" : enclosureNote(part, worlds, X_environmentPart);
    if (!note.empty()) printWarnings({std::string(label) + " " + note});
    if (!at.nearest.witness) return printRow(label, "valid, with nothing near");
    const MeshNames names = distinctMeshNames(clearance.scene(), at.nearest);
    printRow(label, "valid, clearance " + shownLength(at.lower) + ", between '" + names.part + "' and '" +
                        names.environment + "'" + leftOutAt(at));
}

void describeEnds(const Problem& problem, const Mesh& part, const std::vector<Mesh>& worlds) {
    const LoadedScene loaded = loadScene(problem, {}, guardedLoading());
    printWarnings(loaded.notes);
    facts()["notes"] = loaded.notes;
    const SceneClearance clearance(loaded.scene);
    describePose("at the start", clearance, problem.start, part, worlds);
    facts()["at_start"] = poseFacts(clearance, problem.start);
    if (problem.outside) return;
    describePose("at the goal", clearance, problem.goal, part, worlds);
    facts()["at_goal"] = poseFacts(clearance, problem.goal);
}

void describeProblemFile(const std::string& file, const BuildOptions& tree) {
    const Problem problem = readJudged(file);
    const Mesh part = loadPart(problem, guardedLoadMesh);
    const std::vector<Mesh> worlds = loadWorlds(problem, guardedLoadMesh);
    const Mesh environment = joinedEnvironment(worlds);
    const ObstacleGroups obstacles = obstaclesOf(problem, worlds);
    describeProblem(problem, boundingBox(environment), boundingBox(part));
    printObstacles(obstacles);
    facts()["obstacles"] = obstacleFacts(obstacles);
    describeEnds(problem, part, worlds);
    std::cout << "\nPart\n";
    const Model partModel = describeMesh(
        "part", part, problem.meshes.asOmplApp ? "as OMPL.app reads a robot" : "as stored", tree);
    std::cout << "\nEnvironment\n";
    describeMesh("environment", environment,
                 problem.meshes.asOmplApp ? "as OMPL.app reads its world" : "as stored", tree,
                 planning::planningReach(problem, {}, partModel, boundingBox(environment)));
}

double liftTolerance(const Problem& problem, double overlap) {
    return problem.rules.overlap.tolerance.value_or(kLiftTolerance * overlap);
}

/// Why the start is not valid with this overlap.
WhyInvalid whyStartIsInvalid(Problem problem, double overlap) {
    OverlapRules& rules = problem.rules.overlap;
    rules.common = overlap;
    rules.tolerance = liftTolerance(problem, overlap);
    try {
        const SceneClearance clearance(loadScene(problem, {}, guardedLoading()).scene);
        return clearance.whyInvalid(poseOf(problem.start));
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument("no overlap is found that frees the start; tried: " +
                                    std::string(error.what()));
    }
}

/// For a start at which surfaces only touch.
void printSmallLift(const Problem& problem, double partSize) {
    const double overlap = awayFromZero(kSmallLift * partSize, 3);
    const WhyInvalid why = whyStartIsInvalid(problem, overlap);
    if (!why.isValid())
        return printRow("lift",
                        "overlap = " + depthText(overlap) + " does not free the start: " + why.words());
    facts()["lift"] = {{"overlap", toJson(overlap)}};
    printRow("lift", "overlap = " + depthText(overlap) +
                         " frees the start, as every other one does: parts only touch");
}

/// Says how deep obstacles reach into the part at the start, and which overlap frees the start.
void describeLift(const std::string& file) {
    Problem problem = readJudged(file);
    tellProblem(problem);
    const std::vector<FoundOverlap> overlaps = overlapsAtStart(problem);
    facts()["overlaps"] = toJson(overlaps);
    for (const FoundOverlap& found : overlaps) printRow(found.obstacle, describe(found));
    problem.margin = 0;
    problem.rules.margins.clear();
    problem.rules.overlap.common = 0;
    problem.rules.overlap.byName.clear();
    problem.rules.overlap.isThinAllowed = true;
    if (overlaps.empty()) {
        const SceneClearance clearance(loadScene(problem, {}, guardedLoading()).scene);
        const WhyInvalid why = clearance.whyInvalid(poseOf(problem.start));
        printRow("start",
                 "no obstacle reaches into the part" + (why.isValid() ? "" : ", but " + why.words()));
        if (why.kind == WhyInvalid::Kind::kCollides)
            printSmallLift(problem, clearance.scene().part.box().diagonal().norm());
        return;
    }
    double least = 0, enough = 0;
    for (const FoundOverlap& found : overlaps) enough = std::max(enough, found.deepest.upper);
    enough = awayFromZero(enough, 3);
    WhyInvalid why = whyStartIsInvalid(problem, enough);
    for (int doublings = 0; !why.isValid() && doublings < kMostDoublings; ++doublings) {
        least = enough;
        enough *= 2;
        why = whyStartIsInvalid(problem, enough);
    }
    if (!why.isValid())
        throw std::invalid_argument("no overlap up to " + shownLength(enough) +
                                    " frees the start: " + why.words());
    const bool isFromSearch = least > 0;
    while (isFromSearch && enough - least > kLiftError * enough) {
        const double middle = awayFromZero(0.5 * (least + enough), 3);
        (whyStartIsInvalid(problem, middle).isValid() ? enough : least) = middle;
    }
    facts()["lift"] = {{"overlap", toJson(enough)}};
    if (isFromSearch) facts()["lift"]["tolerance"] = toJson(liftTolerance(problem, enough));
    printRow("lift",
             "overlap = " + depthText(enough) +
                 (isFromSearch ? " with overlap.tolerance = " + depthText(liftTolerance(problem, enough))
                               : std::string()) +
                 " frees the start");
}

}  // namespace

int info(const Arguments& arguments) {
    std::string file;
    std::optional<double> scale;
    BuildOptions tree;
    bool isLift = false;
    CommandLine line(
        "clearway info MESH|PROBLEM.cfg [options]",
        "Shows what a mesh or a problem's two meshes hold: triangles, components, box, whether the\n"
        "surface is closed, the conversions on reading, the findings of cleaning, and the tree built.");
    line.argument("MESH|PROBLEM.cfg", to(file));
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
    requireFactsFile(files);

    if (!boost::iends_with(file, ".cfg")) {
        if (isLift)
            throw std::invalid_argument("--lift is given with the mesh '" + file + "', expected a problem");
        LoadOptions load;
        load.scale = scale.value_or(1);
        describeMesh("mesh", guardedLoadMesh(file, load), "as stored", tree);
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
