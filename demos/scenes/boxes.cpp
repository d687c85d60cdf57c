#include <cmath>

#include "demos/scenes/random.h"
#include "demos/scenes/scenes.h"
#include "demos/scenes/solids.h"

namespace clearway::scenes {

namespace {

constexpr double kBoxesLeastClearance = 0.01, kBoxesMostClearance = 20;  // mm
constexpr double kBoxesEase = 0.01;  // extra gap beyond the clearance, as a share of it
constexpr double kWallThickness = 16;
constexpr double kBoxesSlit = 1;   // mm between floor and wall
constexpr double kBoxesRoom = 60;  // mm around the path's positions that planners may use

/// A random whole number of millimetres, which floats hold exactly.
double wholeBetween(Random& random, double low, double high) {
    return std::floor(random.between(low, high + 1));
}

}  // namespace

GeneratedScene makeBoxes(const SceneOptions& options) {
    requireClearance(options.clearance, kBoxesLeastClearance, kBoxesMostClearance);
    requireTriangles(options.partTriangles, "part-triangles", 12);
    requireTriangles(options.environmentTriangles, "environment-triangles", 24);
    Random random(options.seed);
    const Vector3 half{wholeBetween(random, 28, 34), wholeBetween(random, 18, 22),
                       wholeBetween(random, 13, 16)};  // braces fix the order of the random draws
    const double length = wholeBetween(random, 140, 160);
    const Box floor(Vector3(-length, -90, -24), Vector3(length, 50, 0));
    const Box wall(Vector3(-length, 50 + kBoxesSlit, -24),
                   Vector3(length, 50 + kBoxesSlit + kWallThickness, 110));

    GeneratedScene scene;
    scene.name = "boxes";
    Assembly part, environment;
    part.add("part", gridBox(Box(Vector3(-half), half), options.partTriangles));
    const std::size_t ofWall = options.environmentTriangles / 2;
    environment.add("floor", gridBox(floor, options.environmentTriangles - ofWall));
    environment.add("wall", gridBox(wall, ofWall));
    scene.part = part.mesh();
    scene.environment = environment.mesh();

    const double gap = options.clearance * (1 + kBoxesEase), reach = length - half.x() - 10;
    PartState state;
    state.position = Vector3(-reach, wall.min().y() - gap - half.y(), gap + half.z());
    for (const Vector3& motion :
         {Vector3(0, 0, 0), Vector3(2 * reach, 0, 0), Vector3(0, 0, 60), Vector3(-0.5 * reach, -60, 0)}) {
        state.position += motion;
        scene.path.push_back(state);
    }
    statePathAsProblem(scene, kBoxesRoom);
    scene.problem.name = "boxes v1";
    scene.problem.fineness = kWallThickness / 2;
    return scene;
}

}  // namespace clearway::scenes
