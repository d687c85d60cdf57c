#include "program/cli/planning_scene.h"

#include <algorithm>
#include <iostream>
#include <stdexcept>

#include "clearway/planning/plan.h"
#include "program/cli/load_guard.h"
#include "program/cli/print.h"
#include "program/cli/tree_options.h"

namespace clearway::cli {

Scene buildScene(const Problem& problem, const planning::PlanOptions& options, const BuildOptions& tree,
                 const std::string& cache) {
    const Mesh partMesh = guardedLoadPart(problem);
    const ObstacleGroups obstacles = obstaclesOf(problem, guardedLoadWorlds(problem));
    const Model part = buildModel(partMesh, tree, cache);
    const auto reach = planning::planningReach(problem, options, part, boxOf(obstacles));
    printWarnings(obstacles.notes);
    std::shared_ptr<const Solids> partSolids;
    if (obstacles.hasSolids()) {
        const MadeSolids made = makeSolids(partMesh);
        for (const std::string& refusal : made.refusals) {
            printWarnings({"of the part, " + refusal + ": obstacles inside it go unseen"});
        }
        partSolids = made.solids;
    }
    return makeScene(part, partSolids, obstacles, problem.rules, poseOf(problem.start), poseOf(problem.goal),
                     [&](const Mesh& mesh) { return buildModel(mesh, tree, cache, reach); });
}

Mesh shownEnvironment(const Problem& problem) {
    Problem allAlike = problem;
    allAlike.margin = 0;
    allAlike.rules = ObstacleRules();
    allAlike.rules.ignored = problem.rules.ignored;
    const std::vector<Mesh> worlds = guardedLoadWorlds(problem);
    const ObstacleGroups obstacles = obstaclesOf(allAlike, worlds);
    return obstacles.groups.empty() ? joinedEnvironment(worlds) : obstacles.groups[0].mesh;
}

ObstacleGroups obstaclesOf(const Problem& problem, const std::vector<Mesh>& worlds) {
    try {
        return groupObstacles(worlds, problem.margin, problem.rules);
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(problem.file + ": [clearway] " + error.what());
    }
}

Box boxOf(const ObstacleGroups& obstacles) {
    Box box = obstacles.ignoredBox;
    for (const ObstacleGroup& group : obstacles.groups) box.extend(boundingBox(group.mesh));
    return box;
}

std::vector<std::string> inputsOf(const Problem& problem) {
    std::vector<std::string> files = worldFiles(problem);
    files.push_back(problem.file);
    files.push_back(problem.robot);
    return files;
}

namespace {

constexpr std::size_t kMostNames = 6;

std::string namesOf(const std::vector<Component>& components) {
    std::string names;
    for (std::size_t i = 0; i < std::min(components.size(), kMostNames); ++i) {
        names += (i > 0 ? ", '" : "'") + components[i].name + "'";
    }
    if (components.size() > kMostNames) {
        names += " and " + std::to_string(components.size() - kMostNames) + " more";
    }
    return names;
}

/// One group of obstacles, and how it counts.
void printObstacle(const std::vector<Component>& components, std::size_t triangles, double margin,
                   bool isSolid, bool atStart, bool atGoal) {
    std::string row = namesOf(components) + ": " + counted(triangles, "triangle") + ", margin " +
                      readable(margin) + (isSolid ? ", solid" : "");
    if (atStart || atGoal) {
        row += std::string(", ignored near the ") + (atStart && atGoal ? "start and the goal"
                                                     : atStart         ? "start"
                                                                       : "goal");
    }
    printRow("obstacle", row);
}

}  // namespace

void printObstacles(const Scene& scene) {
    const bool isPlain = scene.obstacles.size() == 1 && !scene.obstacles[0].solids && !scene.startContact &&
                         !scene.goalContact && scene.ignoredBox.isEmpty();
    for (const Obstacle& obstacle : scene.obstacles) {
        printMesh("environment", obstacle.model);
        if (isPlain) continue;
        printObstacle(obstacle.model.components(), obstacle.model.report().triangles, obstacle.margin,
                      obstacle.solids != nullptr, obstacle.isIgnoredAtStart, obstacle.isIgnoredAtGoal);
    }
    if (scene.obstacles.empty()) printRow("environment", "all of it is ignored");
    printRow("margin", scene.obstacles.size() == 1
                           ? readable(scene.largestMargin())
                           : "by obstacle, at most " + readable(scene.largestMargin()));
    const auto printContact = [](const char* where, const std::optional<ContactZone>& contact) {
        if (contact) printRow(where, readable(contact->distance));
    };
    printContact("contact at start", scene.startContact);
    printContact("contact at goal", scene.goalContact);
}

void printObstacles(const ObstacleGroups& obstacles) {
    for (const ObstacleGroup& group : obstacles.groups) {
        printObstacle(group.mesh.components, group.mesh.triangles.size(), group.margin,
                      group.solids != nullptr, group.isIgnoredAtStart, group.isIgnoredAtGoal);
    }
    for (const std::string& name : obstacles.ignored) printRow("ignored", "'" + name + "'");
    for (const std::string& note : obstacles.notes) printRow("note", note);
}

void printMesh(const std::string& label, const Model& model) {
    const std::size_t leftOut = model.report().unreachableTriangles;
    printRow(label, model.origin().file + ", " + counted(model.report().triangles, "triangle") +
                        (leftOut > 0 ? ", " + std::to_string(leftOut) + " out of reach left out" : ""));
}

void printWarnings(const std::vector<std::string>& warnings) {
    for (const std::string& warning : warnings) std::cerr << "clearway: warning: " << warning << "\n";
}

}  // namespace clearway::cli
