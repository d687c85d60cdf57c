// A small planning problem in the plane in which different ways have slightly different clearances: a part
// among posts.
#pragma once

#include "clearway/problem.h"
#include "clearway/scene.h"

namespace clearway::testing {

struct PostsScene {
    Scene scene;
    Problem problem;
};

/// SE(2); the part is 20 x 10 x 10, its start and goal are at x = -100 and 100. Between them stand posts of 5
/// x 5 at random places, no two of them nearer than 20.
PostsScene postsScene();

}  // namespace clearway::testing
