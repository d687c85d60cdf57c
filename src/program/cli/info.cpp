// clearway info: what a mesh or a problem holds, what was applied on reading, and the trees it builds.
#include <boost/algorithm/string/predicate.hpp>
#include <iostream>
#include <stdexcept>

#include "clearway/planning/plan.h"
#include "clearway/problem.h"
#include "program/cli/command_line.h"
#include "program/cli/describe_mesh.h"
#include "program/cli/describe_problem.h"
#include "program/cli/load_guard.h"
#include "program/cli/planning_scene.h"
#include "program/cli/tree_options.h"

namespace clearway::cli {

namespace {

void describeMeshFile(const std::string& file, const Options& options, const BuildOptions& tree) {
    LoadOptions load;
    if (options.has("scale")) load.scale = options.positive("scale");
    describeMesh(guardedLoadMesh(file, load), "as stored", tree);
}

void describeProblemFile(const std::string& file, const Options& options, const BuildOptions& tree) {
    if (options.has("scale")) {
        throw std::invalid_argument("--scale is '" + options.text("scale") +
                                    "', expected only with a mesh: a problem's meshes are read as it says");
    }
    const Problem problem = readProblem(file);
    const Mesh part = guardedLoadPart(problem);
    const std::vector<Mesh> worlds = guardedLoadWorlds(problem);
    const Mesh environment = joinedEnvironment(worlds);
    const ObstacleGroups obstacles = obstaclesOf(problem, worlds);
    describeProblem(problem, boundingBox(environment));
    printObstacles(obstacles);
    std::cout << "\nPart\n";
    const Model partModel =
        describeMesh(part, problem.asOmplApp ? "as OMPL.app reads a robot" : "as stored", tree);
    std::cout << "\nEnvironment\n";
    describeMesh(environment, problem.asOmplApp ? "as OMPL.app reads its world" : "as stored", tree,
                 planning::planningReach(problem, {}, partModel, boundingBox(environment)));
}

}  // namespace

int info(const Arguments& arguments) {
    CommandLine commandLine;
    commandLine.usage = "clearway info MESH|PROBLEM.cfg [options]";
    commandLine.purpose =
        "Shows what a mesh or a problem's two meshes hold: triangles, components, box, whether the\n"
        "surface is closed, what was applied on reading, what cleaning did, and the tree built from it.";
    commandLine.positional = {"MESH|PROBLEM.cfg"};
    commandLine.options.add_options()  //
        ("scale", optionValue("F"), "multiplies the mesh's coordinates (1)");
    addTreeOptions(commandLine);
    const std::optional<Options> options = parse(commandLine, arguments);
    if (!options) return kDone;

    const std::string file = options->text(commandLine.positional[0]);
    const BuildOptions tree = treeOptions(*options);
    if (boost::iends_with(file, ".cfg")) {
        describeProblemFile(file, *options, tree);
    } else {
        describeMeshFile(file, *options, tree);
    }
    return kDone;
}

}  // namespace clearway::cli
