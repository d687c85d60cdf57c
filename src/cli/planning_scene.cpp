#include "cli/planning_scene.h"

#include <iostream>

#include "cli/load_guard.h"
#include "cli/print.h"
#include "cli/tree_options.h"
#include "planning/planning_reach.h"

namespace clearway {

Scene buildScene(const Problem& problem, const planning::PlanOptions& options, const BuildOptions& tree,
                 const std::string& cache) {
    const Model part = buildModel(guardedLoadPart(problem), tree, cache);
    const Mesh environment = guardedLoadEnvironment(problem);
    const auto reach = planning::planningReach(problem, options, part, boundingBox(environment));
    return {part, buildModel(environment, tree, cache, reach), problem.margin};
}

void printMesh(const std::string& label, const Model& model) {
    const std::size_t leftOut = model.report().unreachableTriangles;
    printRow(label, model.origin().file + ", " + counted(model.report().triangles, "triangle") +
                        (leftOut > 0 ? ", " + std::to_string(leftOut) + " out of reach left out" : ""));
}

void printWarnings(const std::vector<std::string>& warnings) {
    for (const std::string& warning : warnings) std::cerr << "clearway: warning: " << warning << "\n";
}

}  // namespace clearway
