// A problem's meshes, read the way the problem says.
#include "clearway/obstacle_groups.h"
#include "clearway/problem.h"

namespace clearway {

namespace {

Mesh loadAs(const Problem& problem, const std::string& file, MeshReading omplAppReading) {
    LoadOptions options;
    options.reading = problem.asOmplApp ? omplAppReading : MeshReading::kAsStored;
    return loadMesh(file, options);
}

}  // namespace

Mesh loadPart(const Problem& problem) {
    const bool isSpatial = problem.space == Space::kSe3;
    return loadAs(problem, problem.robot,
                  isSpatial ? MeshReading::kOmplAppRobot : MeshReading::kOmplAppPlanarRobot);
}

std::vector<Mesh> loadWorlds(const Problem& problem) {
    std::vector<Mesh> worlds;
    for (const std::string& file : worldFiles(problem)) {
        worlds.push_back(loadAs(problem, file, MeshReading::kOmplAppEnvironment));
    }
    return worlds;
}

Mesh loadEnvironment(const Problem& problem) {
    return joinedEnvironment(loadWorlds(problem));
}

}  // namespace clearway
