// How deep an obstacle enters a part.
#pragma once

#include <memory>
#include <vector>

#include "clearway/mesh.h"
#include "clearway/types.h"

#pragma GCC visibility push(default)

namespace clearway {

class SurfaceDepth;

/// The point of an obstacle that lies deepest below the part's surface.
struct DeepestPoint {
    double lower = 0;                    ///< its depth is at least this; environment units
    double upper = 0;                    ///< its depth is at most this; environment units
    Vector3 point = Vector3::Zero();     ///< a point of depth `lower`; environment's frame
    std::int64_t obstacleTriangle = -1;  ///< position in its mesh; -1 when no point inside was found
};

/// Measures overlaps with one part. Any number of threads may use it at once.
class OverlapMeter {
  public:
    /// Where components of the part meet, gaps of less than 0.0002 of the part's diagonal count as filled, and
    /// depths may be too small by twice as much. Throws ArgumentError as shrink() does for a part that is
    /// not closed or passes through itself.
    explicit OverlapMeter(const Mesh& part);

    /// Measures as a part that shrink() has shrunk with this tolerance (mesh units, > 0). Gaps of less than
    /// an eighth of the tolerance count as filled, as they do in shrink().
    OverlapMeter(const Mesh& part, double tolerance);

    /// The deepest point of the obstacle's triangles inside the part at the pose; upper is above lower by at
    /// most 1 % or, if more, 1e-4 of the part's diagonal. X_environmentPart: as for distance(). A triangle's depth is
    /// found by halving it, with the distance from its middle to the part's surface as the bound (which changes no
    /// faster than places).
    DeepestPoint deepest(const Mesh& obstacle, const Pose& X_environmentPart) const {
        return deepest(obstacle, X_environmentPart, 0);
    }

    /// leastDepth: the least depth of interest, in environment units. Shallower points may be missed, and upper
    /// exceeds lower by at most leastDepth or 1 %, whichever is more. A leastDepth below 1e-4 of the part's diagonal
    /// counts as that. Throws ArgumentError unless the pose is a rotation and a translation (see requirePose).
    DeepestPoint deepest(const Mesh& obstacle, const Pose& X_environmentPart, double leastDepth) const;

  private:
    std::shared_ptr<const SurfaceDepth> surface_;
};

}  // namespace clearway

#pragma GCC visibility pop
