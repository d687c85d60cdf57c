#include "support/door_scene.h"

#include "support/random_meshes.h"

namespace clearway::testing {
namespace {

void append(Mesh& all, const Vector3& low, const Vector3& high, const std::string& name) {
    const std::vector<Component> before = all.components;
    const auto first = static_cast<std::uint32_t>(all.triangles.size());
    const Mesh wall = boxMesh({low, high}, name);
    all = all.triangles.empty() ? wall : joined(all, wall);
    all.components = before;
    all.components.push_back({name, first, static_cast<std::uint32_t>(wall.triangles.size())});
}

}  // namespace

DoorScene doorScene() {
    DoorScene scene;
    scene.part = boxMesh({Vector3(-2, -2, -2), Vector3(2, 2, 2)}, "block");
    append(scene.box, {-5, -5, -5}, {5, 5, -4}, "floor");
    append(scene.box, {-5, -5, 4}, {5, 5, 5}, "roof");
    append(scene.box, {-5, -5, -4}, {5, -4, 4}, "left");
    append(scene.box, {-5, 4, -4}, {5, 5, 4}, "right");
    append(scene.box, {-5, -4, -4}, {-4, 4, 4}, "back");
    append(scene.box, {4, -4, -4}, {5, 4, 4}, "door");
    scene.problem.name = "door";
    scene.problem.meshes.asOmplApp = false;
    scene.problem.goal.position = {15, 0, 0};
    scene.problem.volume = Box(Vector3(-3, -3, -3), Vector3(18, 3, 3));
    return scene;
}

}  // namespace clearway::testing
