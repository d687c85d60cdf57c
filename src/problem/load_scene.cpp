#include <stdexcept>

#include "clearway/obstacle_groups.h"
#include "clearway/problem.h"

namespace clearway {

namespace {

ObstacleGroups loadObstacles(const Problem& problem) {
    const std::vector<Mesh> worlds = loadWorlds(problem);
    try {
        return groupObstacles(worlds, problem.margin, problem.rules);
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(problem.file + ": [clearway] " + error.what());
    }
}

}  // namespace

LoadedScene loadScene(const Problem& problem, const BuildOptions& options) {
    const Mesh part = loadPart(problem);
    const ObstacleGroups obstacles = loadObstacles(problem);
    std::vector<std::string> notes = obstacles.notes;
    std::shared_ptr<const Solids> partSolids;
    if (obstacles.hasSolids()) {
        const MadeSolids made = makeSolids(part);
        for (const std::string& refusal : made.refusals) {
            notes.push_back("of the part, " + refusal + ": obstacles inside it go unseen");
        }
        partSolids = made.solids;
    }
    const auto build = [&](const Mesh& mesh) { return Model::build(mesh, options); };
    return {makeScene(build(part), partSolids, obstacles, problem.rules, poseOf(problem.start),
                      poseOf(problem.goal), build),
            notes};
}

}  // namespace clearway
