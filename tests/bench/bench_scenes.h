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

/// A scene of bench/linked_rings.h, with its own poses.
constexpr const char* kLinkedRings = "linked-rings-1";

/// One column of the tables of figures.
struct BenchScene {
    const char* name;   ///< "F", "I", ...
    const char* scene;  ///< with its version; a row of demos/scenes/scenes.cpp, or kLinkedRings
    BenchSize full;
    BenchSize small;             ///< for runs that only show that all answers agree
    double collidingShare;       ///< 0: no pose collides, and the distances lie in the range below
    double leastFree, mostFree;  ///< shares of the part's size
    double pathEnd;              ///< poses keep to this first share of the path's states
    bool turns;                  ///< whether the poses also deviate from the path by turning
};

const std::vector<BenchScene>& benchScenes();

/// The row of that name. Throws std::invalid_argument, which lists the names.
const BenchScene& benchSceneNamed(const std::string& name);

/// The meshes, and the poses at which they are queried.
struct BenchTask {
    std::string name;
    std::string sceneName;  ///< with its version; "files" for the user's own
    std::string about;      ///< one line: scene and pose set
    Mesh part;
    Mesh environment;
    std::vector<Pose> poses;

    double partSize() const { return boundingBox(part).diagonal().norm(); }  ///< diagonal of the part's box
    double sceneSize() const { return partSize() + boundingBox(environment).diagonal().norm(); }
};

/// Makes the scene of the given size and its pose set. Trees of the default options serve to find the poses.
BenchTask makeTask(const BenchScene& scene, const BenchSize& size, int poses, std::uint64_t seed);

}  // namespace clearway::testing
