// Sorts triangles into bins along the axes of a frame and finds the plane between two bins that the surface-area heuristic rates
// best: its cost is the sum over both sides of the area of the side's box times the number of its triangles.
// Source: Wald, On fast Construction of SAH-based Bounding Volume Hierarchies, 2007.
#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "build/corner_lanes-inl.h"
#include "build/scratch_array.h"
#include "hwy/highway.h"

#if defined(CLEARWAY_BUILD_SPLIT_BINS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARWAY_BUILD_SPLIT_BINS_INL_H_
#undef CLEARWAY_BUILD_SPLIT_BINS_INL_H_
#else
#define CLEARWAY_BUILD_SPLIT_BINS_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace clearway {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// x, y and z of a point in a frame, and a fourth number that does not matter.
using AxisLanes = hn::CappedTag<float, 4>;

/// The range of twice the triangles' centres along the axes of a frame.
struct CentreRange {
    alignas(16) float low[4] = {kInfinity, kInfinity, kInfinity, kInfinity};
    alignas(16) float high[4] = {-kInfinity, -kInfinity, -kInfinity, -kInfinity};
};

/// The triangles' boxes in a frame: x, y, z of the low corner and of the negated high one.
class FrameBoxes {
  public:
    CentreRange project(const CornerLanes& triangles, const FrameAxes& frame) {
        const FloatLanes d;
        low_.withRoomFor(4 * triangles.paddedCount());
        negatedHigh_.withRoomFor(4 * triangles.paddedCount());
        FloatVector axes[9], leastCentre[3], greatestCentre[3];
        for (std::size_t i = 0; i < 9; ++i) axes[i] = hn::Set(d, frame[i]);
        for (int k = 0; k < 3; ++k) {
            leastCentre[k] = hn::Set(d, kInfinity);
            greatestCentre[k] = hn::Set(d, -kInfinity);
        }
        for (std::size_t i = 0; i < triangles.paddedCount(); i += hn::Lanes(d)) {
            FloatVector low[3], high[3];
            for (int corner = 0; corner < 3; ++corner) {
                const FloatVector x = hn::LoadU(d, triangles.row(0, corner) + i);
                const FloatVector y = hn::LoadU(d, triangles.row(1, corner) + i);
                const FloatVector z = hn::LoadU(d, triangles.row(2, corner) + i);
                for (int k = 0; k < 3; ++k) {
                    const FloatVector place =
                        Along<FloatLanes>(axes[3 * k], axes[3 * k + 1], axes[3 * k + 2], x, y, z);
                    low[k] = corner == 0 ? place : hn::Min(low[k], place);
                    high[k] = corner == 0 ? place : hn::Max(high[k], place);
                }
            }
            for (int k = 0; k < 3; ++k) {
                const FloatVector centre = hn::Add(low[k], high[k]);
                leastCentre[k] = hn::Min(leastCentre[k], centre);
                greatestCentre[k] = hn::Max(greatestCentre[k], centre);
                high[k] = hn::Neg(high[k]);
            }
            hn::StoreInterleaved4(low[0], low[1], low[2], hn::Zero(d), d, low_.data() + 4 * i);
            hn::StoreInterleaved4(high[0], high[1], high[2], hn::Zero(d), d, negatedHigh_.data() + 4 * i);
        }
        CentreRange range;
        for (int k = 0; k < 3; ++k) {
            range.low[k] = LeastOf(d, leastCentre[k]);
            range.high[k] = GreatestOf(d, greatestCentre[k]);
        }
        range.low[3] = range.high[3] = 0;
        return range;
    }

    const float* low(std::size_t i) const { return low_.data() + 4 * i; }
    const float* negatedHigh(std::size_t i) const { return negatedHigh_.data() + 4 * i; }

  private:
    ScratchArray<float> low_, negatedHigh_;
};

/// A plane between two bins.
struct BinnedPlane {
    float cost = kInfinity;
    int axis = -1;     ///< of the frame; -1: no plane parts the triangles
    int lastLeft = 0;  ///< bin
};

/// A triangle's bins along the three axes of a frame.
using BinsOfTriangle = std::array<std::uint8_t, 4>;

class Bins {
  public:
    static constexpr int kMost = 64;

    /// Empties `count` bins, at most kMost, over the range along each axis.
    void clear(int count, const CentreRange& range) {
        count_ = count;
        std::copy(range.low, range.low + 4, rangeLow_);
        for (int k = 0; k < 4; ++k) {
            // Along an axis where all centres coincide, all triangles land in bin 0.
            const float extent = range.high[k] - range.low[k];
            scale_[k] = extent > 1e-30f ? 0.99999f * static_cast<float>(count) / extent : 0.0f;
        }
        std::fill(&low_[0][0][0], &low_[count][0][0], kInfinity);
        std::fill(&negatedHigh_[0][0][0], &negatedHigh_[count][0][0], kInfinity);
        std::fill(&triangles_[0][0], &triangles_[count][0], 0);
    }

    /// Adds triangles and notes their bins. Centres beyond the range count to the first and last bins.
    void add(const FrameBoxes& boxes, std::size_t count, BinsOfTriangle* binsOf) {
        const AxisLanes d;
        const hn::Rebind<std::int32_t, AxisLanes> di;
        alignas(16) std::int32_t bins[4];
        for (std::size_t i = 0; i < count; ++i) {
            const float *low = boxes.low(i), *negatedHigh = boxes.negatedHigh(i);
            for (std::size_t k = 0; k < 4; k += hn::Lanes(d)) {
                const auto centre = hn::Sub(hn::LoadU(d, low + k), hn::LoadU(d, negatedHigh + k));
                const auto place =
                    hn::Mul(hn::Sub(centre, hn::Load(d, rangeLow_ + k)), hn::Load(d, scale_ + k));
                const auto last = hn::Set(d, static_cast<float>(count_ - 1));
                hn::Store(hn::ConvertTo(di, hn::Min(hn::Max(place, hn::Zero(d)), last)), di, bins + k);
            }
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const std::int32_t bin = bins[axis];
                binsOf[i][axis] = static_cast<std::uint8_t>(bin);
                lower(low_[bin][axis], low);
                lower(negatedHigh_[bin][axis], negatedHigh);
                ++triangles_[bin][axis];
            }
        }
    }

    /// Adds the triangles of other bins, over the same range.
    void add(const Bins& other) {
        for (int bin = 0; bin < count_; ++bin) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                lower(low_[bin][axis], other.low_[bin][axis]);
                lower(negatedHigh_[bin][axis], other.negatedHigh_[bin][axis]);
                triangles_[bin][axis] += other.triangles_[bin][axis];
            }
        }
    }

    /// The cheapest plane; infinite cost when all centres coincide.
    BinnedPlane cheapestPlane() const {
        const AxisLanes d;
        alignas(16) float costs[4];
        alignas(16) std::int32_t lastLeft[4];
        for (std::size_t axis = 0; axis < 4; axis += hn::Lanes(d))
            sweep(d, axis, costs + axis, lastLeft + axis);
        BinnedPlane best;
        for (int axis = 0; axis < 3; ++axis) {
            if (costs[axis] < best.cost) best = {costs[axis], axis, lastLeft[axis]};
        }
        return best;
    }

  private:
    static HWY_INLINE void lower(float* least, const float* values) {
        const AxisLanes d;
        for (std::size_t k = 0; k < 4; k += hn::Lanes(d))
            hn::Store(hn::Min(hn::Load(d, least + k), hn::LoadU(d, values + k)), d, least + k);
    }

    /// The boxes and numbers of the triangles in some bins, one axis in each lane.
    template <class D>
    struct Sides {
        using V = hn::Vec<D>;
        V low[3], negatedHigh[3], triangles;

        explicit HWY_INLINE Sides(D d) : triangles(hn::Zero(d)) {
            for (int k = 0; k < 3; ++k) low[k] = negatedHigh[k] = hn::Set(d, kInfinity);
        }

        HWY_INLINE void add(D d, const Bins& bins, int bin, std::size_t axis) {
            V x, y, z, unused;
            hn::LoadInterleaved4(d, bins.low_[bin][axis], x, y, z, unused);
            low[0] = hn::Min(low[0], x);
            low[1] = hn::Min(low[1], y);
            low[2] = hn::Min(low[2], z);
            hn::LoadInterleaved4(d, bins.negatedHigh_[bin][axis], x, y, z, unused);
            negatedHigh[0] = hn::Min(negatedHigh[0], x);
            negatedHigh[1] = hn::Min(negatedHigh[1], y);
            negatedHigh[2] = hn::Min(negatedHigh[2], z);
            const hn::Rebind<std::int32_t, D> di;
            triangles = hn::Add(triangles, hn::ConvertTo(d, hn::LoadU(di, bins.triangles_[bin] + axis)));
        }

        /// Half the area times the number of triangles; infinite without triangles.
        HWY_INLINE V cost(D d) const {
            const V a = hn::Add(low[0], negatedHigh[0]), b = hn::Add(low[1], negatedHigh[1]);
            const V c =
                hn::Add(low[2], negatedHigh[2]);  // the negated sides: their products are those of the sides
            const V area = hn::Add(hn::Mul(a, hn::Add(b, c)), hn::Mul(b, c));
            return hn::IfThenElse(hn::Gt(triangles, hn::Zero(d)), hn::Mul(area, triangles),
                                  hn::Set(d, kInfinity));
        }
    };

    /// The cheapest planes along as many axes as there are lanes.
    template <class D>
    void sweep(D d, std::size_t axis, float* costs, std::int32_t* lastLeft) const {
        using V = hn::Vec<D>;
        const hn::Rebind<std::int32_t, D> di;
        V rightCosts[kMost];  // of the bins after each
        Sides<D> right(d), left(d);
        for (int bin = count_ - 1; bin > 0; --bin) {
            right.add(d, *this, bin, axis);
            rightCosts[bin - 1] = right.cost(d);
        }
        V least = hn::Set(d, kInfinity);
        auto last = hn::Zero(d);
        for (int bin = 0; bin + 1 < count_; ++bin) {
            left.add(d, *this, bin, axis);
            const V cost = hn::Add(left.cost(d), rightCosts[bin]);
            const auto isLess = hn::Lt(cost, least);
            least = hn::IfThenElse(isLess, cost, least);
            last = hn::IfThenElse(isLess, hn::Set(d, static_cast<float>(bin)), last);
        }
        hn::StoreU(least, d, costs);
        hn::StoreU(hn::ConvertTo(di, last), di, lastLeft);
    }

    int count_ = 0;
    alignas(16) float rangeLow_[4];
    alignas(16) float scale_[4];
    alignas(64) float low_[kMost + 1][4][4];  ///< by bin and axis; the fourth axis stays empty
    alignas(64) float negatedHigh_[kMost + 1][4][4];
    alignas(64) std::int32_t triangles_[kMost + 1][4];
};

}  // namespace HWY_NAMESPACE
}  // namespace clearway
HWY_AFTER_NAMESPACE();

#endif  // CLEARWAY_BUILD_SPLIT_BINS_INL_H_
