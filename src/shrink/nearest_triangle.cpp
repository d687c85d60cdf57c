#include "shrink/nearest_triangle.h"

#include <algorithm>
#include <cmath>

namespace clearway {
namespace {

constexpr double kSliver =
    1e-4;  ///< height of a triangle in its longest edges; of a lower one the normal is rounded too much

/// A mesh of one triangle whose corners are one point, the origin.
Mesh pointMesh() {
    Mesh mesh;
    mesh.vertices = {Vector3::Zero()};
    mesh.triangles = {{0, 0, 0}};
    return mesh;
}

double distanceToSegment(const Vector3& point, const Vector3& a, const Vector3& b) {
    const Vector3 along = b - a;
    const double lengthSquared = along.squaredNorm();
    const double s = lengthSquared > 0 ? std::clamp(along.dot(point - a) / lengthSquared, 0.0, 1.0) : 0.0;
    return (point - (a + s * along)).stableNorm();
}

}  // namespace

double distanceToTriangle(const Vector3& point, const Corners3& triangle) {
    const auto& [a, b, c] = triangle;
    const Vector3 normal = (b - a).cross(c - a);
    const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    // The distance to the edges is never less; it stands also where squares of lengths are too large for numbers.
    bool isAbove = normal.norm() > kSliver * longest && std::isfinite(normal.norm());
    for (std::size_t k = 0; k < 3 && isAbove; ++k) {
        const Vector3 &from = triangle[k], &to = triangle[(k + 1) % 3];
        isAbove = normal.dot((to - from).cross(point - from)) >= 0;
    }
    if (isAbove) return std::abs(normal.dot(point - a)) / normal.norm();
    return std::min(
        {distanceToSegment(point, a, b), distanceToSegment(point, b, c), distanceToSegment(point, c, a)});
}

NearestTriangle::NearestTriangle(Model surface)
    : surface_(std::move(surface)), point_(Model::build(pointMesh())) {}

NearestTriangle::Place NearestTriangle::of(const Vector3& point) {
    Pose pose;
    pose.translation = point;
    const DistanceResult found = distance(point_, surface_, pose, {}, workspace_);
    return {found.distance, static_cast<std::uint32_t>(found.witness->environmentTriangle),
            found.witness->pointOnEnvironment};
}

}  // namespace clearway
