#include "model/box_tree.h"

namespace clearway {
namespace {

/// Puts a zero bit before each of the low 16 bits.
std::uint32_t spread(std::uint32_t bits) {
    bits = (bits | (bits << 8)) & 0x00ff00ff;
    bits = (bits | (bits << 4)) & 0x0f0f0f0f;
    bits = (bits | (bits << 2)) & 0x33333333;
    return (bits | (bits << 1)) & 0x55555555;
}

}  // namespace

BoxTree::BoxTree(const std::vector<Box>& boxes) {
    if (boxes.empty()) return;
    Box all;
    for (const Box& box : boxes) all.extend(box);
    middle_ = 0.5 * all.min() + 0.5 * all.max();
    const double halfSide = (0.5 * all.max() - 0.5 * all.min()).maxCoeff();
    scale_ = std::min(1 / halfSide, std::numeric_limits<double>::max());  // of a single point, any will do

    std::vector<FloatBox> placed(boxes.size());
    std::vector<std::uint64_t> keys(boxes.size());  // the place on the curve, then the box
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const FloatBox& box = placed[i] = inTree(boxes[i]);
        const auto bitsOf = [&](int axis) {
            return spread(static_cast<std::uint32_t>((box.min[axis] + box.max[axis] + 4) * 8191));
        };
        keys[i] = (std::uint64_t(bitsOf(0) | (bitsOf(1) << 1)) << 32) | i;
    }
    std::sort(keys.begin(), keys.end());
    std::vector<FloatBox> sorted;
    for (const std::uint64_t key : keys) {
        order_.push_back(static_cast<std::uint32_t>(key));
        sorted.push_back(placed[order_.back()]);
    }
    addLevel(sorted);
}

BoxTree::FloatBox BoxTree::inTree(const Box& box) const {
    FloatBox placed;
    for (int axis = 0; axis < 3; ++axis) {
        const auto place = [&](double x) {
            return static_cast<float>(std::clamp(scale_ * (x - middle_[axis]), -2.0, 2.0));
        };
        placed.min[axis] = place(box.min()[axis]);
        placed.max[axis] = place(box.max()[axis]);
    }
    return placed;
}

/// Adds a level of nodes around the boxes, and all levels above.
void BoxTree::addLevel(const std::vector<FloatBox>& boxes) {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    std::vector<Node>& nodes = levels_.emplace_back((boxes.size() + kWidth - 1) / kWidth);
    std::vector<FloatBox> around(nodes.size());
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        for (int axis = 0; axis < 3; ++axis) {
            Lanes &min = nodes[n].min[axis], &max = nodes[n].max[axis];
            min = kInfinity;  // a place without a box meets nothing
            max = -kInfinity;
            for (std::size_t k = 0; k < kWidth && kWidth * n + k < boxes.size(); ++k) {
                min[k] = boxes[kWidth * n + k].min[axis];
                max[k] = boxes[kWidth * n + k].max[axis];
            }
            around[n].min[axis] = min.minCoeff();
            around[n].max[axis] = max.maxCoeff();
        }
    }
    if (around.size() > 1) addLevel(around);
}

}  // namespace clearway
