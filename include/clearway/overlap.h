// How deep an obstacle enters a part.
#pragma once

#include <memory>
#include <vector>

#include "clearway/mesh.h"
#include "clearway/model.h"
#include "clearway/types.h"

#pragma GCC visibility push(default)

namespace clearway {

class Solids;

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
    /// Depths are measured as shrink() means them: to the nearest triangle of any component. Throws ArgumentError as shrink()
    /// does for a part that is not closed.
    explicit OverlapMeter(const Mesh& part);

    /// Takes the model of the part, which the caller has built already, and its solids (see makeSolids) where the caller has made them.
    OverlapMeter(const Mesh& part, const Model& model, std::shared_ptr<const Solids> solids = nullptr);

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
    struct Surface;
    std::shared_ptr<const Surface> surface_;
};

}  // namespace clearway

#pragma GCC visibility pop
