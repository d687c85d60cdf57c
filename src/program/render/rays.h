// Traces rays with Embree, for pictures alone. Embree works in float, so it never answers a distance.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>

#include "program/render/surface.h"

namespace clearway::render {

/// The place of one copy of a shape: x -> rotation * x + translation.
struct Placement {
    Eigen::Matrix3f rotation = Eigen::Matrix3f::Identity();
    Vector3f translation = Vector3f::Zero();
};

struct Ray {
    Vector3f origin;
    Vector3f direction;  ///< its length is the unit of lengths along the ray
    float least = 0;     ///< the ray begins here
};

struct RayHit {
    float along = 0;  ///< the point is origin + along * direction
    std::uint32_t body = 0;
    std::uint32_t triangle = 0;
    float u = 0, v = 0;  ///< weights of the triangle's second and third corner
    bool isHit = false;
};

/// The bodies that rays can meet. After finish() any number of threads may trace rays.
class RayScene {
  public:
    RayScene();
    ~RayScene();
    RayScene(const RayScene&) = delete;
    RayScene& operator=(const RayScene&) = delete;

    /// Copies the surface. Returns the number of the shape.
    std::size_t addShape(const Surface& surface);
    /// Adds a copy of a shape. Bodies are numbered from 0 in the order of these calls.
    void addBody(std::size_t shape, const Placement& placement);
    /// Moves a body. finish() is then to be called again.
    void moveBody(std::size_t body, const Placement& placement);
    /// Rays pass through a hidden body. finish() is then to be called again.
    void showBody(std::size_t body, bool isShown);
    /// Builds Embree's trees. Throws std::runtime_error with Embree's error code on failure.
    void finish();

    RayHit nearest(const Ray& ray) const;
    /// Whether the ray meets anything before length `most`.
    bool isBlocked(const Ray& ray, float most) const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace clearway::render
