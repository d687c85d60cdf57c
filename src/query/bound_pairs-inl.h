// Lower bounds of several pairs of triangles at once in double, from their exact vertices: what a query is
// left with when many pairs are equally close, as faces parallel to each other are.
#include "hwy/highway.h"
#include "kernels/tri_tri_distance-inl.h"
#include "query/refine.h"
#include "query/workspace_state.h"

#if defined(CLEARWAY_QUERY_BOUND_PAIRS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARWAY_QUERY_BOUND_PAIRS_INL_H_
#undef CLEARWAY_QUERY_BOUND_PAIRS_INL_H_
#else
#define CLEARWAY_QUERY_BOUND_PAIRS_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace clearway {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

constexpr int kPairsTogether = 8;

/// Rounding of a bound of BoundPairs, first order, vectors, in u64. Of M: 1.8 for the first corner moved. Of
/// the pair's size, its largest coordinate: difference from the base 1.8; edges of the part, up to 3.5
/// long, 3.5, their rotation 17.4 and place 1.8; edges of the environment 1.8; products of a slab gap 5.2
/// + 5.2, their difference 1.8. Of the gap itself: length of the direction 2.5, division 1, what is taken
/// off 2.
constexpr double kPairPlaceRoundoffs = 2;
constexpr double kPairSizeRoundoffs = 40;
constexpr double kGapRoundoffs = 6;

/// PairVertices, one pair per lane.
struct alignas(64) PairRows {
    double firstCorner[3][kPairsTogether];
    double partEdge[2][3][kPairsTogether];
    double environmentEdge[2][3][kPairsTogether];
};

HWY_INLINE void FillPair(const PairVertices& pair, int lane, PairRows& rows) {
    for (int row = 0; row < 3; ++row) {
        rows.firstCorner[row][lane] = pair.firstCorner[row];
        for (int edge = 0; edge < 2; ++edge) {
            rows.partEdge[edge][row][lane] = pair.partEdge[edge][row];
            rows.environmentEdge[edge][row][lane] = pair.environmentEdge[edge][row];
        }
    }
}

/// lower[k] <= the distance of pair k, query units, for k < count <= kPairsTogether; 0 at worst. Close to the
/// distance unless the triangles are flat or touch.
inline HWY_NOINLINE void BoundPairs(const PairQuery& query, const Candidate* pairs, int count,
                                    double (&lower)[kPairsTogether]) {
    const hn::CappedTag<double, kPairsTogether> d;
    using V = hn::Vec<decltype(d)>;
    PairRows rows;
    for (int lane = 0; lane < kPairsTogether; ++lane) {
        const Candidate& pair = pairs[lane < count ? lane : 0];
        FillPair(pairVertices(query, pair.triangles), lane, rows);
    }
    for (size_t i = 0; i < size_t(count); i += hn::Lanes(d)) {
        const auto load3 = [&](const double(&from)[3][kPairsTogether]) HWY_ATTR {
            return Lanes3<V>{hn::Load(d, from[0] + i), hn::Load(d, from[1] + i), hn::Load(d, from[2] + i)};
        };
        const auto moved = [&](const Lanes3<V>& v) HWY_ATTR {
            const auto along = [&](int row) HWY_ATTR {
                const double* R = query.R + 3 * row;
                return Dot(Lanes3<V>{hn::Set(d, R[0]), hn::Set(d, R[1]), hn::Set(d, R[2])}, v);
            };
            return Lanes3<V>{along(0), along(1), along(2)};
        };
        Triangles<V> a, b;
        a.corner[0] = load3(rows.firstCorner);
        b.corner[0] = {hn::Zero(d), hn::Zero(d), hn::Zero(d)};
        for (int edge = 0; edge < 2; ++edge) {
            a.corner[edge + 1] = a.corner[0] + moved(load3(rows.partEdge[edge]));
            b.corner[edge + 1] = load3(rows.environmentEdge[edge]);
        }
        V size = hn::Zero(d);
        for (const Triangles<V>* t : {&a, &b}) {
            for (const Lanes3<V>& corner : t->corner) {
                size =
                    hn::Max(size, hn::Max(hn::Abs(corner.x), hn::Max(hn::Abs(corner.y), hn::Abs(corner.z))));
            }
        }
        const TrianglePair<V> pair(a, b);
        const V gap = TriangleDistance(d, pair, FaceSeparation(d, pair)).lower;
        const V slack = hn::Set(d, kUnitRoundoffDouble) *
                        hn::MulAdd(size, hn::Set(d, kPairSizeRoundoffs),
                                   hn::Set(d, kPairPlaceRoundoffs * query.largestCoordinate));
        const V proved = hn::NegMulAdd(gap, hn::Set(d, kGapRoundoffs * kUnitRoundoffDouble), gap - slack);
        // By select, so that NaN proves nothing.
        hn::StoreU(hn::IfThenElseZero(hn::Gt(proved, hn::Zero(d)), proved), d, lower + i);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace clearway
HWY_AFTER_NAMESPACE();

#endif
