#include "support/window_scene.h"

#include "support/random_meshes.h"

namespace clearway::testing {
namespace {

Mesh wallPiece(const Vector3& low, const Vector3& high, const std::string& name) {
    Mesh piece = translated(box((high - low) / 2, 3), (low + high) / 2);
    piece.components = {{name, 0, static_cast<std::uint32_t>(piece.triangles.size())}};
    return piece;
}

void append(Mesh& all, const Mesh& piece) {
    const auto firstVertex = static_cast<std::uint32_t>(all.vertices.size());
    const auto firstTriangle = static_cast<std::uint32_t>(all.triangles.size());
    all.vertices.insert(all.vertices.end(), piece.vertices.begin(), piece.vertices.end());
    for (TriangleIndices t : piece.triangles) {
        for (std::uint32_t& i : t) i += firstVertex;
        all.triangles.push_back(t);
    }
    Component component = piece.components[0];
    component.firstTriangle = firstTriangle;
    all.components.push_back(component);
}

Mesh wallWithWindow() {
    Mesh wall;
    append(wall, wallPiece({-2, -100, -100}, {2, 100, -16}, "below"));
    append(wall, wallPiece({-2, -100, 16}, {2, 100, 100}, "above"));
    append(wall, wallPiece({-2, -100, -16}, {2, -32, 16}, "left"));
    append(wall, wallPiece({-2, 32, -16}, {2, 100, 16}, "right"));
    return wall;
}

}  // namespace

WindowScene windowScene(const BuildOptions& options) {
    Mesh part = box({30, 20, 5}, 2);
    part.components = {{"plate", 0, static_cast<std::uint32_t>(part.triangles.size())}};
    const Mesh wall = wallWithWindow();
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
