#include "support/window_scene.h"

#include "support/random_meshes.h"

namespace clearway::testing {
namespace {

Mesh wallPiece(const Vector3& low, const Vector3& high, const std::string& name) {
    return named(translated(box((high - low) / 2, 3), (low + high) / 2), name);
}

}  // namespace

WindowScene windowScene(const BuildOptions& options) {
    const Mesh part = named(box({30, 20, 5}, 2), "plate");
    const Mesh wall = assembled({wallPiece({-2, -100, -100}, {2, 100, -16}, "below"),
                                 wallPiece({-2, -100, 16}, {2, 100, 100}, "above"),
                                 wallPiece({-2, -100, -16}, {2, -32, 16}, "left"),
                                 wallPiece({-2, 32, -16}, {2, 100, 16}, "right")});
    WindowScene result{part, wall, {Model::build(part, options), Model::build(wall, options), 0}, {}};
    result.problem.name = "window";
    result.problem.start.position = {-60, 0, 0};
    result.problem.start.rotation = Eigen::AngleAxisd(M_PI / 2, Vector3::UnitX());
    result.problem.goal.position = {60, 0, 0};
    result.problem.goal.rotation = result.problem.start.rotation;
    result.problem.volume = Box(Vector3(-80, -40, -40), Vector3(80, 40, 40));
    result.problem.fineness = 1;
    return result;
}

}  // namespace clearway::testing
