// Lower bounds in double for several pairs of triangles at once, from their exact vertices. They settle the
// pairs that a query is left with when many pairs are equally close, for example between parallel faces.
#include "hwy/highway.h"
#include "kernels/tri_tri_distance-inl.h"
#include "query/queries.h"

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

/// The PairVertices of several pairs, one pair per lane.
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

/// Lower bounds of the pairs' distances, query units: lower[k] <= the distance of pair k for k < count <=
/// kPairsTogether. A bound is close to the distance unless the triangles are flat or touch, and 0 at worst.
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
        const V proved = hn::NegMulAdd(gap, hn::Set(d, kPairGapRoundoffs * kUnitRoundoffDouble), gap - slack);
        // With this select NaN proves nothing.
        hn::StoreU(hn::IfThenElseZero(hn::Gt(proved, hn::Zero(d)), proved), d, lower + i);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace clearway
HWY_AFTER_NAMESPACE();

#endif
