// A small planning problem that has no path: a part in a closed box whose one wall is called "door".
#pragma once

#include "clearway/mesh.h"
#include "clearway/problem.h"

namespace clearway::testing {

struct DoorScene {
    Mesh part;  ///< one component, "block": a cube with sides of 4
    Mesh
        box;  ///< components "floor", "roof", "left", "right", "back" and, at x = 4, "door": 8 x 8 x 8 inside
    Problem
        problem;  ///< SE(3); from the middle of the box to 11 beyond the door; only through the door within the bounds
};

DoorScene doorScene();

}  // namespace clearway::testing
