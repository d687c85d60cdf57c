// Bins along the three axes of a frame: which plane between two bins parts triangles at least cost.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include <Eigen/Core>

namespace clearway {

using Lanes4 = Eigen::Array4f;  ///< x, y, z and a fourth that does not matter

struct CornerLanes {
    Lanes4 corner[3];
};

/// A box that grows.
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

/// A plane between two bins. What it costs is the sum over both sides of area times number of triangles.
struct BinnedPlane {
    float cost = std::numeric_limits<float>::infinity();
    int axis = -1;     ///< of the frame; -1: no plane parts the triangles
    int lastLeft = 0;  ///< bin
};

/// Kept from node to node for its storage.
class Bins {
  public:
    static constexpr int kMost = 64;

    /// Sorts triangles into bins along the columns of axes and returns the cheapest plane; infinite cost when
    /// all centres coincide.
    BinnedPlane cheapestPlane(const std::vector<CornerLanes>& triangles, const Eigen::Matrix3f& axes);

    /// By triangle, along an axis of the last frame.
    std::vector<std::uint8_t>& binsAlong(int axis) { return binOf_[axis]; }

  private:
    struct Bin {
        Extent extent;
        int count = 0;
    };

    /// Boxes of the triangles, and of twice their centres, in a frame.
    Extent project(const std::vector<CornerLanes>& triangles, const Eigen::Matrix3f& axes);
    void fill(const Extent& centres, int count);
    BinnedPlane sweep(int axis, int count) const;

    std::vector<Extent> boxes_;
    std::vector<std::uint8_t> binOf_[3];
    std::array<Bin, kMost> bins_[3];
};

}  // namespace clearway
