#include "support/planar_scenes.h"

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

Mesh post(double x, double low, double high) {
    const Vector3 half(2, (high - low) / 2, 20);
    return translated(box(half, 3), {x, (low + high) / 2, 0});
}

/// A wall with gates from -12 to 12 and, on one side (1 or -1), from 25 to 57.
Mesh wall(double x, double side) {
    const auto from = [=](double a, double b) {
        return post(x, std::min(side * a, side * b), std::max(side * a, side * b));
    };
    return joined(from(12, 25), joined(from(57, 100), from(-100, -12)));
}

/// A part that goes from -x to x.
PlanarScene sceneOf(const std::string& name, const Mesh& environment, double x, double halfRoomX) {
    PlanarScene result{Scene(Model::build(box({10, 5, 5}, 2)), Model::build(environment)), {}};
    result.problem.name = name;
    result.problem.space = Space::kSe2;
    result.problem.start.position = {-x, 0, 0};
    result.problem.goal.position = {x, 0, 0};
    result.problem.volume = Box(Vector3(-halfRoomX, -70, 0), Vector3(halfRoomX, 70, 0));
    return result;
}

}  // namespace

PlanarScene gatesScene() {
    return sceneOf("gates", joined(wall(-30, 1), wall(30, -1)), 80, 100);
}

PlanarScene postsScene() {
    return sceneOf("posts", posts(), 100, 120);
}

}  // namespace clearway::testing
