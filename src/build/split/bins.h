// Sorts triangles into bins and finds the plane between two bins that the surface-area heuristic rates best.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace clearway {

using Lanes4 = Eigen::Array4f;  ///< x, y, z and a fourth that does not matter

struct CornerLanes {
    Lanes4 corner[3];
};

/// A growing box.
struct Extent {
    Lanes4 low = Lanes4::Constant(std::numeric_limits<float>::infinity());
    Lanes4 high = Lanes4::Constant(-std::numeric_limits<float>::infinity());

    void add(const Extent& other) {
        low = low.min(other.low);
        high = high.max(other.high);
    }
    float halfArea() const {
        const Lanes4 side = high - low;
        return side[0] * side[1] + side[1] * side[2] + side[2] * side[0];
    }
};

/// A plane between two bins. Its cost is the sum over both sides of area times number of triangles.
struct BinnedPlane {
    float cost = std::numeric_limits<float>::infinity();
    int axis = -1;     ///< of the frame; -1: no plane parts the triangles
    int lastLeft = 0;  ///< bin
};

/// Bins along the three axes of a frame. Reused from node to node for its storage.
class Bins {
  public:
    static constexpr int kMost = 64;

    /// Sorts triangles into bins along the columns of axes and returns the cheapest plane; infinite cost when
    /// all centres coincide. cornersOf: gives the corners of triangle 0 to triangles - 1.
    template <class CornersOf>
    BinnedPlane cheapestPlane(std::size_t triangles, const CornersOf& cornersOf, const Eigen::Matrix3f& axes);

    /// The bin of each triangle along an axis of the last frame.
    std::vector<std::uint8_t>& binsAlong(int axis) { return binOf_[axis]; }

  private:
    /// Small nodes need few bins; clearing and sweeping empty bins would be most of the work.
    static int binsFor(std::size_t triangles) {
        return static_cast<int>(std::min<std::size_t>(kMost, 2 * triangles + 4));
    }

    struct Bin {
        Extent extent;
        int count = 0;
    };

    /// Computes the triangles' boxes in a frame; returns the box of twice their centres.
    template <class CornersOf>
    Extent project(std::size_t triangles, const CornersOf& cornersOf, const Eigen::Matrix3f& axes);
    void fill(const Extent& centres, int count);
    BinnedPlane sweep(int axis, int count) const;

    std::vector<Extent> boxes_;
    std::vector<std::uint8_t> binOf_[3];
    std::array<Bin, kMost> bins_[3];
};

template <class CornersOf>
BinnedPlane Bins::cheapestPlane(std::size_t triangles, const CornersOf& cornersOf,
                                const Eigen::Matrix3f& axes) {
    const Extent centres = project(triangles, cornersOf, axes);
    const int count = binsFor(triangles);
    fill(centres, count);
    BinnedPlane best;
    for (int axis = 0; axis < 3; ++axis) {
        const BinnedPlane plane = sweep(axis, count);
        if (plane.cost < best.cost) best = plane;
    }
    return best;
}

template <class CornersOf>
Extent Bins::project(std::size_t triangles, const CornersOf& cornersOf, const Eigen::Matrix3f& axes) {
    Lanes4 rows[3];
    for (int k = 0; k < 3; ++k) rows[k] << axes(k, 0), axes(k, 1), axes(k, 2), 0.0f;
    boxes_.resize(triangles);
    Extent centres;
    for (std::size_t i = 0; i < triangles; ++i) {
        const CornerLanes corners = cornersOf(i);
        const auto projected = [&](int k) -> Lanes4 {
            const Lanes4& corner = corners.corner[k];
            return corner[0] * rows[0] + corner[1] * rows[1] + corner[2] * rows[2];
        };
        const Lanes4 a = projected(0), b = projected(1), c = projected(2);
        boxes_[i].low = a.min(b).min(c);
        boxes_[i].high = a.max(b).max(c);
        const Lanes4 centre = boxes_[i].low + boxes_[i].high;
        centres.add({centre, centre});
    }
    return centres;
}

}  // namespace clearway
