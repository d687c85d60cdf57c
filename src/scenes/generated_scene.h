// What a scene generator makes: two meshes, a problem and a path that solves it, and how they become files.
#pragma once

#include <string>
#include <vector>

#include "clearway/mesh.h"
#include "clearway/problem.h"

namespace clearway {

struct GeneratedScene {
    std::string name;  ///< of the files
    Mesh part;
    Mesh environment;
    Problem problem;  ///< its start and goal, like the path, are for the part's coordinates as they are here
    std::vector<PartState> path;
};

/// The files writeScene wrote.
struct SceneFiles {
    std::string part;
    std::string environment;
    std::string problem;
    std::string path;
};

/// Writes NAME_part.obj, NAME_environment.obj, NAME.cfg and NAME.path into the folder, which is made if need
/// be. OMPL.app moves a part so that the mean of its vertices, as assimp counts them, becomes its origin. The
/// part is written moved by that mean, and start, goal and path are changed with it: they then hold for the
/// part as the file has it, and for the part as OMPL.app reads it, which differ by float rounding alone.
/// Throws std::runtime_error when a file or the folder cannot be written.
SceneFiles writeScene(const GeneratedScene& scene, const std::string& folder);

}  // namespace clearway
