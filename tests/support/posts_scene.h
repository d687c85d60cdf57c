// A small planning problem in the plane whose ways differ in clearance by little: a part among posts.
#pragma once

#include "clearway/problem.h"
#include "clearway/scene.h"

namespace clearway::testing {

struct PostsScene {
    Scene scene;
    Problem problem;
};

/// SE(2); the part is 20 x 10 x 10, its start and goal are at x = -100 and 100. Between them stand posts of
/// 5 x 5, at random but no two of them nearer than 20.
PostsScene postsScene();

}  // namespace clearway::testing
