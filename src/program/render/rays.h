// Rays against bodies, by Embree: for pictures alone. It works in float, so it never answers a distance.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "program/render/surface.h"

namespace clearway::render {

/// Where a copy of a shape stands: x -> rotation * x + translation.
struct Placement {
    Eigen::Matrix3f rotation = Eigen::Matrix3f::Identity();
    Vector3f translation = Vector3f::Zero();
};

struct Ray {
    Vector3f origin;
    Vector3f direction;  ///< lengths along the ray count in its lengths
    float least = 0;     ///< nothing nearer is met
};

struct RayHit {
    float along = 0;  ///< the point is origin + along * direction
    std::uint32_t body = 0;
    std::uint32_t triangle = 0;
    float u = 0, v = 0;  ///< weights of the triangle's second and third corner
    bool isHit = false;
};

/// Bodies to shoot at. After finish() any number of threads may.
class RayScene {
  public:
    RayScene();
    ~RayScene();
    RayScene(const RayScene&) = delete;
    RayScene& operator=(const RayScene&) = delete;

    /// The surface is read during the call only. Returns its number.
    std::size_t addShape(const Surface& surface);
    /// Bodies are numbered from 0 in the order they are added.
    void addBody(std::size_t shape, const Placement& placement);
    /// Throws std::runtime_error with Embree's code when it fails.
    void finish();

    RayHit nearest(const Ray& ray) const;
    /// Whether anything is met up to `most` along the ray.
    bool isBlocked(const Ray& ray, float most) const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace clearway::render
