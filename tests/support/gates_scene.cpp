#include "support/gates_scene.h"

#include <algorithm>

#include "support/random_meshes.h"

namespace clearway::testing {
namespace {

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

}  // namespace

GatesScene gatesScene() {
    const Mesh part = box({10, 5, 5}, 2);
    GatesScene result{Scene(Model::build(part), Model::build(joined(wall(-30, 1), wall(30, -1)))), {}};
    result.problem.name = "gates";
    result.problem.space = Space::kSe2;
    result.problem.start.position = {-80, 0, 0};
    result.problem.goal.position = {80, 0, 0};
    result.problem.volume = Box(Vector3(-100, -70, 0), Vector3(100, 70, 0));
    return result;
}

}  // namespace clearway::testing
