#include "build/split/bins.h"

namespace clearway {

void Bins::fill(const Extent& centres, int count) {
    // An axis along which all centres coincide gets scale 0, so that all triangles land in bin 0.
    const Lanes4 extent = centres.high - centres.low;
    const Lanes4 scale = (extent > std::numeric_limits<float>::min())
                             .select(static_cast<float>(count) / extent, Lanes4::Zero());
    for (int axis = 0; axis < 3; ++axis) {
        binOf_[axis].resize(boxes_.size());
        std::fill(bins_[axis].begin(), bins_[axis].begin() + count, Bin{});
    }
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
        const Extent box = boxes_[i];  // a copy, which the bins cannot overwrite
        const Lanes4 place = (box.low + box.high - centres.low) * scale;
        for (int axis = 0; axis < 3; ++axis) {
            const int index = std::clamp(static_cast<int>(place[axis]), 0, count - 1);
            binOf_[axis][i] = static_cast<std::uint8_t>(index);
            Bin& bin = bins_[axis][index];
            bin.extent.add(box);
            ++bin.count;
        }
    }
}

BinnedPlane Bins::sweep(int axis, int count) const {
    constexpr float kNoCost = std::numeric_limits<float>::infinity();
    const std::array<Bin, kMost>& bins = bins_[axis];
    std::array<float, kMost> rightCost;
    Extent right;
    int rightCount = 0;
    float cost = kNoCost;  // of the bins from b on; infinite where there are no triangles
    for (int b = count - 1; b > 0; --b) {
        if (bins[b].count > 0) {
            right.add(bins[b].extent);
            rightCount += bins[b].count;
            cost = right.halfArea() * static_cast<float>(rightCount);
        }
        rightCost[b - 1] = cost;
    }
    BinnedPlane best;
    Extent left;
    int leftCount = 0;
    for (int b = 0; b + 1 < count; ++b) {
        if (bins[b].count == 0) continue;  // the plane before this bin is equal
        left.add(bins[b].extent);
        leftCount += bins[b].count;
        const float both = left.halfArea() * static_cast<float>(leftCount) + rightCost[b];
        if (both < best.cost) best = {both, axis, b};
    }
    return best;
}

}  // namespace clearway
