// A tree of boxes that finds those which meet a given box. Eight boxes to a node, in the order of their middles along a Z-order curve of
// x and y, so a node's children need no pointers.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "clearway/types.h"

namespace clearway {

class BoxTree {
  public:
    BoxTree() = default;
    explicit BoxTree(const std::vector<Box>& boxes);

    /// Calls take(i) once for each box i that meets the given one, and perhaps for boxes that miss it by a float's rounding.
    template <class Take>
    void eachMeeting(const Box& box, const Take& take) const;

  private:
    static constexpr std::uint32_t kWidth = 8;
    static constexpr std::size_t kDeepest = 11;  ///< 8^11 > 2^32 boxes

    using Lanes = Eigen::Array<float, kWidth, 1>;  ///< one of each child
    struct Node {
        Lanes min[3], max[3];
    };
    /// A box in the tree's coordinates, in which the box around all lies within +-1.
    struct FloatBox {
        float min[3], max[3];
    };

    /// Monotone in each coordinate, so boxes that meet still meet after all roundings.
    FloatBox inTree(const Box& box) const;
    void addLevel(const std::vector<FloatBox>& boxes);

    Vector3 middle_ = Vector3::Zero();
    double scale_ = 1;
    std::vector<std::uint32_t> order_;  ///< the box of each place in the lowest level
    std::vector<std::vector<Node>>
        levels_;  ///< the lowest first; child k of node n is box or node 8 n + k of the level below
};

template <class Take>
void BoxTree::eachMeeting(const Box& box, const Take& take) const {
    if (levels_.empty()) return;
    const FloatBox asked = inTree(box);
    struct Open {
        std::uint32_t level, node;
    };
    std::array<Open, kDeepest*(kWidth - 1) + 1> open;
    std::size_t count = 0;
    open[count++] = {static_cast<std::uint32_t>(levels_.size() - 1), 0};
    while (count > 0) {
        const auto [level, number] = open[--count];
        const Node& node = levels_[level][number];
        // The largest of the gaps along the axes. The loops of a compiler are slower here than Eigen's.
        Lanes gap = Lanes::Constant(-std::numeric_limits<float>::infinity());
        for (int axis = 0; axis < 3; ++axis) {
            gap = gap.max(node.min[axis] - asked.max[axis]).max(asked.min[axis] - node.max[axis]);
        }
        for (std::uint32_t k = 0; k < kWidth; ++k) {
            if (gap[k] > 0) continue;
            const std::uint32_t child = kWidth * number + k;
            if (level == 0) {
                take(order_[child]);
            } else {
                open[count++] = {level - 1, child};
            }
        }
    }
}

}  // namespace clearway
