// From a problem to the scene that planning asks about.
#include <stdexcept>

#include "clearway/obstacle_groups.h"
#include "clearway/problem.h"
#include "problem/outside.h"

namespace clearway {

ObstacleGroups obstaclesOf(const Problem& problem, const std::vector<Mesh>& worlds) {
    requireNoGoalContact(problem);
    try {
        return groupObstacles(worlds, problem.margin, problem.rules);
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(problem.file + ": [clearway] " + error.what());
    }
}

LoadedScene loadScene(const Problem& problem, const BuildOptions& options, const SceneLoading& loading) {
    const Mesh partMesh = loadPart(problem, loading.read);
    const ObstacleGroups obstacles = obstaclesOf(problem, loadWorlds(problem, loading.read));
    const Model part = loading.build(partMesh, options, std::nullopt);
    std::optional<Reach> reach;
    if (loading.reach) reach = loading.reach(part, obstacles.environmentBox());
    std::vector<std::string> notes = obstacles.notes;
    std::shared_ptr<const Solids> partSolids;
    if (obstacles.hasSolids()) {
        const MadeSolids made = makeSolids(partMesh);
        for (const std::string& refusal : made.refusals) {
            notes.push_back("part: " + refusal + "; obstacles inside it go unnoticed");
        }
        partSolids = made.solids;
    }
    return {makeScene(part, partSolids, obstacles, problem.rules, poseOf(problem.start), poseOf(problem.goal),
                      [&](const Mesh& mesh) { return loading.build(mesh, options, reach); }),
            notes};
}

}  // namespace clearway
