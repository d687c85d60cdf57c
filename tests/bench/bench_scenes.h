// The scenes and pose sets that queries are measured on.
#pragma once

#include <string>
#include <vector>

#include "bench/pose_sets.h"
#include "clearway/build_options.h"
#include "clearway/mesh.h"

namespace clearway::testing {

struct BenchSize {
    std::size_t partTriangles;
    std::size_t environmentTriangles;
};

/// One column of the figures.
struct BenchScene {
    const char* name;   ///< "E", "F", ...
    const char* scene;  ///< a row of scenes/scenes.h, with its version
    BenchSize full;
    BenchSize small;             ///< for runs that only show that all agree
    double collidingShare;       ///< 0: none collides, and the distances lie in the range below
    double leastFree, mostFree;  ///< of the part's size
    double pathEnd;              ///< poses keep to this first share of the path's states
    bool turns;                  ///< whether the poses deviate from the path by turning too
};

const std::vector<BenchScene>& benchScenes();

/// Throws std::invalid_argument that lists the names.
const BenchScene& benchSceneNamed(const std::string& name);

/// The meshes and the poses to ask about.
struct BenchTask {
    std::string name;
    std::string about;  ///< one line: scene and pose set
    Mesh part;
    Mesh environment;
    std::vector<Pose> poses;

    double partSize() const;  ///< diagonal of the part's box
    double sceneSize() const;
};

/// The scene of the given size with its pose set. The poses are found with trees of the default options.
BenchTask makeTask(const BenchScene& scene, const BenchSize& size, int poses, std::uint64_t seed);

}  // namespace clearway::testing
