#include "build/split/bins.h"

#include <algorithm>

namespace clearway {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// Small nodes need few bins; sweeping those that are empty would be most of the work.
int binsFor(std::size_t triangles) {
    return static_cast<int>(std::min<std::size_t>(Bins::kMost, 2 * triangles + 4));
}

}  // namespace

BinnedPlane Bins::cheapestPlane(const std::vector<CornerLanes>& triangles, const Eigen::Matrix3f& axes) {
    const Extent centres = project(triangles, axes);
    const int count = binsFor(triangles.size());
    fill(centres, count);
    BinnedPlane best;
    for (int axis = 0; axis < 3; ++axis) {
        const BinnedPlane plane = sweep(axis, count);
        if (plane.cost < best.cost) best = plane;
    }
    return best;
}

Extent Bins::project(const std::vector<CornerLanes>& triangles, const Eigen::Matrix3f& axes) {
    Lanes4 rows[3];
    for (int k = 0; k < 3; ++k) rows[k] << axes(k, 0), axes(k, 1), axes(k, 2), 0.0f;
    boxes_.resize(triangles.size());
    Extent centres;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const auto projected = [&](int k) -> Lanes4 {
            const Lanes4& corner = triangles[i].corner[k];
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

void Bins::fill(const Extent& centres, int count) {
    // Where all centres are equal the scale is infinite and 0 times it NaN: the axis gets the one bin 0.
    const Lanes4 extent = centres.high - centres.low;
    const Lanes4 scale = (extent > std::numeric_limits<float>::min())
                             .select(static_cast<float>(count) / extent, Lanes4::Zero());
    for (int axis = 0; axis < 3; ++axis) {
        binOf_[axis].resize(boxes_.size());
        std::fill(bins_[axis].begin(), bins_[axis].begin() + count, Bin{});
    }
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
        const Lanes4 place = (boxes_[i].low + boxes_[i].high - centres.low) * scale;
        for (int axis = 0; axis < 3; ++axis) {
            const int index = std::clamp(static_cast<int>(place[axis]), 0, count - 1);
            binOf_[axis][i] = static_cast<std::uint8_t>(index);
            Bin& bin = bins_[axis][index];
            bin.extent.add(boxes_[i]);
            ++bin.count;
        }
    }
}

BinnedPlane Bins::sweep(int axis, int count) const {
    const std::array<Bin, kMost>& bins = bins_[axis];
    std::array<float, kMost> rightCost;
    Extent right;
    int rightCount = 0;
    for (int b = count - 1; b > 0; --b) {
        if (bins[b].count > 0) right.add(bins[b].extent);
        rightCount += bins[b].count;
        rightCost[b - 1] = rightCount > 0 ? right.halfArea() * static_cast<float>(rightCount) : kInfinity;
    }
    BinnedPlane best;
    Extent left;
    int leftCount = 0;
    for (int b = 0; b + 1 < count; ++b) {
        if (bins[b].count == 0) continue;  // the plane before it does the same
        left.add(bins[b].extent);
        leftCount += bins[b].count;
        const float cost = left.halfArea() * static_cast<float>(leftCount) + rightCost[b];
        if (cost < best.cost) best = {cost, axis, b};
    }
    return best;
}

}  // namespace clearway
