// Whether a ray crosses a triangle, with the sign of the crossing. Double arithmetic decides where a bound of its error does, then
// double-double, then whole numbers. A ray that meets an edge or a corner counts as moved aside by less than any number ("Simulation of
// Simplicity", Edelsbrunner and Muecke, ACM Trans. Graphics 9, 1990).
#pragma once

#include <array>

#include "clearway/types.h"

namespace clearway {

/// A triangle's corners, in mesh coordinates.
using CornerPointers = std::array<const Vector3*, 3>;

/// The ray along a mesh's z axis from a point, in exact arithmetic of the poses of both. The poses must outlive it.
class ZRay {
  public:
    ZRay(const Pose& X_aMesh, const Pose& X_aPoint, const Vector3& point);

    /// A box in mesh coordinates that holds the ray's true origin: the rounded one, widened by its error bound. The poses' rotation
    /// defects are at most kPoseDefect.
    Box aroundOrigin() const {
        return {(origin_.array() - error_).matrix(), (origin_.array() + error_).matrix()};
    }

    /// 1 when the ray leaves through the triangle's front, -1 when it enters there, 0 when it misses the triangle.
    int crossing(const CornerPointers& corners) const;

  private:
    int exactCrossing(const CornerPointers& corners) const;

    const Pose &X_aMesh_, &X_aPoint_;
    Vector3 point_, origin_;  ///< the origin in mesh coordinates, rounded
    double error_;            ///< upper bound of that rounding's length
};

}  // namespace clearway
