#include "program/render/stage.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace clearway::render {

namespace {

constexpr int kMostWalls = 24;  ///< walls of ghosts that one ray passes
constexpr float kPast = 1e-5f;  ///< restarts a ray beyond the wall of a ghost; lengths along the ray

}  // namespace

GhostWalls ghostsAlong(const Stage& ghosts, Ray ray, float most) {
    GhostWalls walls;
    for (int wall = 0; wall < kMostWalls && walls.count < GhostWalls::kMost; ++wall) {
        const RayHit hit = ghosts.rays().nearest(ray);
        if (!hit.isHit || hit.along > most) break;
        if (!walls.hold(hit.body)) walls.hits[walls.count++] = hit;
        ray.least = hit.along + kPast;
    }
    return walls;
}

std::size_t Stage::addShape(Surface surface) {
    shapes_.push_back(std::move(surface));
    return rays_.addShape(shapes_.back());
}

void Stage::addBody(Body body) {
    rays_.addBody(body.shape, body.placement);
    bodies_.push_back(std::move(body));
}

void Stage::changeBody(std::size_t body, Body changed) {
    rays_.moveBody(body, changed.placement);
    bodies_[body] = std::move(changed);
}

std::uint32_t Stage::componentOf(const RayHit& hit) const {
    return shapeOf(bodies_[hit.body]).components[hit.triangle];
}

Vector3f Stage::facetOf(const RayHit& hit) const {
    const Body& body = bodies_[hit.body];
    const Surface& surface = shapeOf(body);
    const TriangleIndices& triangle = surface.triangles[hit.triangle];
    const Vector3f &a = surface.vertices[triangle[0]], &b = surface.vertices[triangle[1]],
                   &c = surface.vertices[triangle[2]];
    return body.placement.rotation * (b - a).cross(c - a).stableNormalized();
}

SeenPoint Stage::seenAt(const Ray& ray, const RayHit& hit) const {
    const Body& body = bodies_[hit.body];
    const auto& corners = shapeOf(body).normals[hit.triangle];
    const Vector3f smooth = (1 - hit.u - hit.v) * corners[0] + hit.u * corners[1] + hit.v * corners[2];
    SeenPoint seen;
    seen.point = ray.origin + hit.along * ray.direction;
    seen.facet = facetOf(hit);
    seen.normal = (body.placement.rotation * smooth).stableNormalized();
    if (seen.facet.dot(ray.direction) > 0) {
        seen.facet = -seen.facet;
        seen.normal = -seen.normal;
    }
    if (seen.normal.dot(ray.direction) >= 0)
        seen.normal = seen.facet;  // the smoothed normal points away from the camera
    seen.isHatched = body.isHatched;
    seen.colour = body.colours[std::min<std::size_t>(componentOf(hit), body.colours.size() - 1)];
    return seen;
}

std::uint32_t Stage::seamKey(const RayHit& hit) const {
    if (!hit.isHit) return 0;
    return bodies_[hit.body].hasSeams ? componentOf(hit) + 1 : 1;
}

}  // namespace clearway::render
