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

/// Corners of up to kPairLanes pairs; row 3 corner + coordinate.
struct alignas(64) PairLanes {
    float part[9][kPairLanes];
    float environment[9][kPairLanes];
};

/// Two leaves in the environment's axes, relative to the environment leaf's centre, in query units: their
/// corners are then numbers of the leaves' size, whatever the distance from the origin, and roundingError is
/// small with them.
class LeafPairs {
  public:
    HWY_INLINE LeafPairs(const PairQuery& query, const Leaf& part, const Leaf& environment)
        : part_(part),
          environment_(environment),
          total_(int(part.triangleCount * environment.triangleCount)) {
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

        const int n = int(part.triangleCount);
        const float* stored = query.part->leafVertices.data() + 9 * size_t(part.firstTriangle);
        for (int corner = 0; corner < 3; ++corner) {
            for (int i = 0; i < n; ++i) {
                float v[3];
                for (int k = 0; k < 3; ++k) v[k] = stored[(3 * corner + k) * n + i] * query.partLeafToQuery;
                for (int row = 0; row < 3; ++row) {
                    const float* R = query.rotation + 3 * row;
                    moved_[3 * corner + row][i] = R[0] * v[0] + R[1] * v[1] + R[2] * v[2] + offset[row];
                }
            }
        }
        environmentCorners_ = query.environment->leafVertices.data() + 9 * size_t(environment.firstTriangle);
        environmentScale_ = query.environmentLeafToQuery;
    }

    int total() const { return total_; }

    /// e: a slab gap or distance computed from these corners is off by at most this.
    float roundingError() const { return roundingError_; }

    /// Positions in the trees of the pair's triangles.
    std::uint32_t partTriangle(int pair) const {
        return part_.firstTriangle + pair / environment_.triangleCount;
    }
    std::uint32_t environmentTriangle(int pair) const {
        return environment_.firstTriangle + pair % environment_.triangleCount;
    }

    /// Fills the lanes with the pairs from `first` on; lanes past the last pair repeat it. Returns how many
    /// pairs are new.
    HWY_INLINE int fill(int first, PairLanes& lanes) const {
        const int m = int(environment_.triangleCount);
        const int count = total_ - first < kPairLanes ? total_ - first : kPairLanes;
        for (int lane = 0; lane < kPairLanes; ++lane) {
            const int pair = first + (lane < count ? lane : count - 1);
            const int i = pair / m, j = pair % m;
            for (int row = 0; row < 9; ++row) {
                lanes.part[row][lane] = moved_[row][i];
                lanes.environment[row][lane] = environmentCorners_[row * m + j] * environmentScale_;
            }
        }
        return count;
    }

  private:
    const Leaf& part_;
    const Leaf& environment_;
    int total_;
    float roundingError_;
    float moved_[9][kLargestLeaf];
    const float* environmentCorners_;
    float environmentScale_;
};

/// Loads a register's worth of one side's triangles.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Triangles<V> LoadTriangles(D d, const float (&rows)[9][kPairLanes], size_t lane) {
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
