// Small convex bodies that are cut by planes.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "clearway/mesh.h"
#include "clearway/types.h"

namespace clearway {

class Polytope {
  public:
    struct Corner {
        Vector3 point;
        std::uint32_t planes;  ///< a bit for each plane that the corner lies on
    };

    explicit Polytope(const std::array<Vector3, 4>& tetrahedron);

    const std::vector<Corner>& corners() const { return corners_; }
    bool isEmpty() const { return corners_.empty(); }
    Vector3 centre() const;  ///< the mean of the corners

    /// The piece where a linear function is at least 0, given its values at the corners. Not for bodies cut 28 times.
    Polytope cut(const std::vector<double>& values) const;

    /// The piece where height(point) >= 0.
    template <class Height>
    Polytope above(const Height& height) const {
        std::vector<double> values;
        for (const Corner& corner : corners_) values.push_back(height(corner.point));
        return cut(values);
    }

    /// Whether all corners have height 0, or there is none.
    template <class Height>
    bool isFlat(const Height& height) const {
        for (const Corner& corner : corners_) {
            if (height(corner.point) != 0) return false;
        }
        return true;
    }

    /// Whether it has few planes and corners, so that cutting it some times more takes little.
    bool isSimple() const { return planeCount_ <= 20 && corners_.size() <= 32; }

    /// The surface, of which triangles of one face may overlap.
    Mesh surface() const;

  private:
    Polytope() = default;

    std::vector<Corner> corners_;
    int planeCount_ = 4;
};

}  // namespace clearway
