// What a scene generator makes: two meshes, a problem and a path that solves it, and how they become files.
#pragma once

#include <string>
#include <vector>

#include "clearway/mesh.h"
#include "clearway/problem.h"

namespace clearway::scenes {

struct GeneratedScene {
    std::string name;  ///< of the files
    Mesh part;
    Mesh environment;
    Problem problem;  ///< its start and goal, like the path, are for the part's coordinates as they are here
    std::vector<PartState> path;
};

/// What a scene's files are called.
struct SceneFiles {
    std::string part;
    std::string environment;
    std::string problem;
    std::string path;
    std::string replay;   ///< poses for benchmarks
    std::string preview;  ///< a picture
};

/// Writes NAME_part.obj, NAME_environment.obj, NAME.cfg and NAME.path into the folder, which is made if need
/// be. OMPL.app moves a part so that the mean of its vertices, as assimp counts them, becomes its origin. The
/// part is written moved by that mean, and start, goal and path are changed with it: they then hold for the
/// part as the file has it, and for the part as OMPL.app reads it, which differ by float rounding alone.
/// replay and preview are written by nobody here, but are known to be writable. Files of these names that
/// were there, of another scene maybe, are removed first.
/// Throws std::runtime_error when a file or the folder cannot be written.
SceneFiles writeScene(const GeneratedScene& scene, const std::string& folder);

/// Puts lines, each as "# line", before what is in a .cfg, .path or .poses file. Throws std::runtime_error
/// when it cannot be read or written.
void addComment(const std::string& file, const std::vector<std::string>& lines);

}  // namespace clearway::scenes
