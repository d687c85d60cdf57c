#include "support/door_scene.h"

#include "support/random_meshes.h"

namespace clearway::testing {

DoorScene doorScene() {
    DoorScene scene;
    scene.part = boxMesh({Vector3(-2, -2, -2), Vector3(2, 2, 2)}, "block");
    scene.box = assembled({boxMesh({Vector3(-5, -5, -5), Vector3(5, 5, -4)}, "floor"),
                           boxMesh({Vector3(-5, -5, 4), Vector3(5, 5, 5)}, "roof"),
                           boxMesh({Vector3(-5, -5, -4), Vector3(5, -4, 4)}, "left"),
                           boxMesh({Vector3(-5, 4, -4), Vector3(5, 5, 4)}, "right"),
                           boxMesh({Vector3(-5, -4, -4), Vector3(-4, 4, 4)}, "back"),
                           boxMesh({Vector3(4, -4, -4), Vector3(5, 4, 4)}, "door")});
    scene.problem.name = "door";
    scene.problem.meshes.asOmplApp = false;
    scene.problem.goal.position = {15, 0, 0};
    scene.problem.volume = Box(Vector3(-3, -3, -3), Vector3(18, 3, 3));
    return scene;
}

}  // namespace clearway::testing
