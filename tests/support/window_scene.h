// A small planning problem: a flat part must turn by 90 degrees to fit through a window in a wall that fills
// the bounds.
#pragma once

#include "clearway/mesh.h"
#include "clearway/problem.h"
#include "clearway/scene.h"

namespace clearway::testing {

struct WindowScene {
    Mesh partMesh;    ///< one component, "plate": 60 x 40 x 10 about its origin
    Mesh wallMesh;    ///< components "below", "above", "left", "right"; 4 thick, at x = 0; the window is 52
                      ///< wide, 22 high
    Scene scene;      ///< margin 0
    Problem problem;  ///< SE(3); start and goal 60 before and behind the wall, standing on edge; fineness 1
};

WindowScene windowScene(const BuildOptions& options = {});

}  // namespace clearway::testing
