// A problem's meshes, read the way the problem says.
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

Mesh loadEnvironment(const Problem& problem) {
    return loadAs(problem, problem.world, MeshReading::kOmplAppEnvironment);
}

}  // namespace clearway
