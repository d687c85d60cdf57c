// All pairs of triangles of two leaves, laid out one pair per lane for the triangle kernels.
#include "hwy/highway.h"
#include "kernels/certificate-inl.h"
#include "query/pair_query.h"

#if defined(CLEARWAY_QUERY_LEAF_PAIRS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARWAY_QUERY_LEAF_PAIRS_INL_H_
#undef CLEARWAY_QUERY_LEAF_PAIRS_INL_H_
#else
#define CLEARWAY_QUERY_LEAF_PAIRS_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace clearway {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

constexpr int kPairLanes = 16;    ///< pairs given to a kernel at once
constexpr int kLargestLeaf = 16;  ///< triangles

/// Corners of up to kPairLanes pairs; row 3 corner + coordinate. Rows are longer than their lanes, so that
/// whole registers may be stored at any lane.
struct alignas(64) PairLanes {
    static constexpr int kRow = 2 * kPairLanes;
    float part[9][kRow];
    float environment[9][kRow];
};

/// Two leaves in the environment's axes, relative to the environment leaf's centre, in query units: their
/// corners are then numbers of the leaves' size, whatever the distance from the origin, and roundingError is
/// small with them.
class LeafPairs {
  public:
    HWY_INLINE LeafPairs(const PairQuery& query, const Leaf& part, const Leaf& environment)
        : partFirst_(part.firstTriangle),
          environmentFirst_(environment.firstTriangle),
          partCount_(int(part.triangleCount)),
          environmentCount_(int(environment.triangleCount)) {
        float offset[3];
        double offsetSquared = 0;
        for (int row = 0; row < 3; ++row) {
            const double* R = query.R + 3 * row;
            const double between = (R[0] * part.centre[0] + R[1] * part.centre[1] + R[2] * part.centre[2] +
                                    query.t[row] - environment.centre[row]) *
                                   query.perMeshUnit;
            offset[row] = static_cast<float>(between);
            offsetSquared += between * between;
        }
        const double reach = double(part.radius) * query.partLeafToQuery +
                             double(environment.radius) * query.environmentLeafToQuery +
                             __builtin_sqrt(offsetSquared);
        roundingError_ = static_cast<float>(
            (kTriangleSlack * kUnitRoundoffFloat * reach + query.offsetSlack) * (1 + 1e-6));
        movePart(query, part, offset);
        environmentCorners_ = query.environment->leafVertices.data() + 9 * size_t(environment.firstTriangle);
        environmentScale_ = query.environmentLeafToQuery;
    }

    int total() const { return partCount_ * environmentCount_; }
    int partCount() const { return partCount_; }

    /// e: a slab gap or distance computed from these corners is off by at most this.
    float roundingError() const { return roundingError_; }

    /// Part triangles whose pairs fit the lanes together.
    int partTrianglesAtOnce() const { return kPairLanes / environmentCount_; }

    /// Fills the lanes with the pairs of part triangles first, first + 1, ..., last - 1 and every environment
    /// triangle, in that order. Returns the number of pairs; what lanes past the last one hold means nothing.
    HWY_INLINE int fill(int first, int last, PairLanes& lanes) const {
        const hn::CappedTag<float, kPairLanes> d;
        const int m = environmentCount_;
        const auto scale = hn::Set(d, environmentScale_);
        const int count = (last - first) * m;
        for (int row = 0; row < 9; ++row) {
            // What a register holds past the last environment triangle is overwritten by the next part
            // triangle.
            for (int i = first; i < last; ++i) {
                const auto corner = hn::Set(d, moved_[row][i]);
                for (int lane = 0; lane < m; lane += int(hn::Lanes(d))) {
                    const int to = (i - first) * m + lane;
                    hn::StoreU(corner, d, lanes.part[row] + to);
                    const auto corners = hn::LoadU(d, environmentCorners_ + row * m + lane);
                    hn::StoreU(hn::Mul(corners, scale), d, lanes.environment[row] + to);
                }
            }
        }
        return count;
    }

    /// Position in its tree of the lane's triangle, for lanes filled from part triangle `first` on.
    std::uint32_t partTriangle(int first, int lane) const {
        return partFirst_ + std::uint32_t(first + lane / environmentCount_);
    }
    std::uint32_t environmentTriangle(int lane) const {
        return environmentFirst_ + std::uint32_t(lane % environmentCount_);
    }

  private:
    HWY_INLINE void movePart(const PairQuery& query, const Leaf& part, const float* offset) {
        const hn::CappedTag<float, kLargestLeaf> d;
        const int n = partCount_;
        const float* stored = query.part->leafVertices.data() + 9 * size_t(part.firstTriangle);
        const auto scale = hn::Set(d, query.partLeafToQuery);
        for (int corner = 0; corner < 3; ++corner) {
            for (int i = 0; i < n; i += int(hn::Lanes(d))) {
                const float* from = stored + 3 * corner * n + i;
                const auto x = hn::Mul(hn::LoadU(d, from), scale);
                const auto y = hn::Mul(hn::LoadU(d, from + n), scale);
                const auto z = hn::Mul(hn::LoadU(d, from + 2 * n), scale);
                for (int row = 0; row < 3; ++row) {
                    const float* R = query.rotation + 3 * row;
                    auto sum = hn::MulAdd(hn::Set(d, R[2]), z, hn::Set(d, offset[row]));
                    sum = hn::MulAdd(hn::Set(d, R[1]), y, sum);
                    sum = hn::MulAdd(hn::Set(d, R[0]), x, sum);
                    hn::StoreU(sum, d, moved_[3 * corner + row] + i);
                }
            }
        }
    }

    std::uint32_t partFirst_;
    std::uint32_t environmentFirst_;
    int partCount_;
    int environmentCount_;
    float roundingError_;
    float moved_[9][2 * kLargestLeaf];
    const float* environmentCorners_;
    float environmentScale_;
};

/// Loads a register's worth of one side's triangles.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Triangles<V> LoadTriangles(D d, const float (&rows)[9][PairLanes::kRow], size_t lane) {
    Triangles<V> t;
    for (int corner = 0; corner < 3; ++corner) {
        t.corner[corner] = {hn::Load(d, rows[3 * corner] + lane), hn::Load(d, rows[3 * corner + 1] + lane),
                            hn::Load(d, rows[3 * corner + 2] + lane)};
    }
    return t;
}

}  // namespace HWY_NAMESPACE
}  // namespace clearway
HWY_AFTER_NAMESPACE();

#endif
