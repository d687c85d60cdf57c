// The nearest triangle of a surface.
#pragma once

#include <cstdint>

#include "clearway/mesh.h"
#include "clearway/model.h"
#include "clearway/query.h"
#include "shrink/oriented_surface.h"

namespace clearway {

/// The distance from the point to the nearest point of the triangle, or to that of its edges if the triangle is a
/// sliver. Never less than the distance, except for rounding.
double distanceToTriangle(const Vector3& point, const Corners3& triangle);

/// Answers for one thread.
class NearestTriangle {
  public:
    explicit NearestTriangle(Model surface);

    struct Place {
        double distance;         ///< not rounded in one direction
        std::uint32_t triangle;  ///< its position in the surface's mesh
        Vector3 point;           ///< the nearest one of the surface
    };
    Place of(const Vector3& point);

    const Model& model() const { return surface_; }

  private:
    Model surface_, point_;
    Workspace workspace_;
};

}  // namespace clearway
