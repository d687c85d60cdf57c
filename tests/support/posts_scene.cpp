#include "support/posts_scene.h"

#include <algorithm>
#include <vector>

#include "support/random_meshes.h"

namespace clearway::testing {
namespace {

constexpr std::uint64_t kPostsSeed = 5;
constexpr int kPosts = 26;
constexpr double kApart = 25;  ///< between centres
constexpr double kHalfX = 75, kHalfY = 70;

std::vector<Vector3> centres() {
    Random random(kPostsSeed);
    std::vector<Vector3> found;
    while (found.size() < kPosts) {
        const double x = random.uniform(-kHalfX, kHalfX), y = random.uniform(-kHalfY, kHalfY);
        const Vector3 centre(x, y, 0);
        const bool isApart = std::all_of(found.begin(), found.end(), [&](const Vector3& other) {
            return (other - centre).norm() >= kApart;
        });
        if (isApart) found.push_back(centre);
    }
    return found;
}

Mesh posts() {
    Mesh all;
    for (const Vector3& centre : centres()) {
        all = joined(all, translated(box({2.5, 2.5, 20}, 2), centre));
    }
    return all;
}

}  // namespace

PostsScene postsScene() {
    PostsScene result{Scene(Model::build(box({10, 5, 5}, 2)), Model::build(posts())), {}};
    result.problem.name = "posts";
    result.problem.space = Space::kSe2;
    result.problem.start.position = {-100, 0, 0};
    result.problem.goal.position = {100, 0, 0};
    result.problem.volume = Box(Vector3(-120, -70, 0), Vector3(120, 70, 0));
    return result;
}

}  // namespace clearway::testing
