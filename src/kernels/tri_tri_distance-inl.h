// Distance of pairs of triangles, one pair per lane: an upper bound from a feasible pair of points and a
// lower bound from slabs across the best directions.
//
// The closest points of two disjoint triangles lie on a pair of edges or on a corner and the other face: 9 +
// 6 cases. Edge pairs are solved by the cross product of the edges, which keeps its accuracy when they are
// nearly parallel; the result is clamped and projected back and forth once, so every pair scored is a pair of
// points of the triangles. Triangles that pierce each other are not told apart from near ones here: their
// lower bound is not above 0, and they are resolved later.
#include "hwy/highway.h"
#include "kernels/certificate-inl.h"
#include "kernels/vector3-inl.h"

#if defined(CLEARWAY_KERNELS_TRI_TRI_DISTANCE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARWAY_KERNELS_TRI_TRI_DISTANCE_INL_H_
#undef CLEARWAY_KERNELS_TRI_TRI_DISTANCE_INL_H_
#else
#define CLEARWAY_KERNELS_TRI_TRI_DISTANCE_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace clearway {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class V>
struct TriangleBounds {
    V lower;    ///< slab gap: a true lower bound but for rounding, may be negative
    V upper;    ///< distance of two points of the triangles: a true upper bound but for rounding
    V feature;  ///< where these two points are, as query/refine.h numbers it
};

/// a / b, or 0 where b is not above 0.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V QuotientOrZero(D d, V a, V b) {
    return hn::IfThenElse(hn::Gt(b, hn::Zero(d)), hn::Div(a, b), hn::Zero(d));
}

/// Difference q - p of near points of the edges p0 + s u and q0 + t v, s and t in [0, 1]; w = q0 - p0.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Lanes3<V> EdgeDifference(D d, const Lanes3<V>& w, const Lanes3<V>& u, const Lanes3<V>& v) {
    const V zero = hn::Zero(d), one = hn::Set(d, hn::TFromD<D>(1));
    const Lanes3<V> n = Cross(u, v);
    const V uu = Dot(u, u), vv = Dot(v, v), uv = Dot(u, v), wu = Dot(w, u), wv = Dot(w, v);
    V s = hn::Clamp(QuotientOrZero(d, Dot(Cross(w, v), n), Dot(n, n)), zero, one);
    const V t = hn::Clamp(QuotientOrZero(d, hn::MulSub(s, uv, wv), vv), zero, one);
    s = hn::Clamp(QuotientOrZero(d, hn::MulAdd(t, uv, wu), uu), zero, one);
    return AddScaled(AddScaled(w, t, v), hn::Neg(s), u);
}

/// Difference q - p of the point p and the point of the triangle q0 + s u + t v below it, clamped to the
/// triangle; w = p - q0, n = u x v.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Lanes3<V> FaceDifference(D d, const Lanes3<V>& w, const Lanes3<V>& u, const Lanes3<V>& v,
                                    const Lanes3<V>& n, V nn) {
    const V zero = hn::Zero(d), one = hn::Set(d, hn::TFromD<D>(1));
    const V s = hn::Clamp(QuotientOrZero(d, Dot(Cross(w, v), n), nn), zero, one);
    const V t = hn::Clamp(QuotientOrZero(d, Dot(Cross(u, w), n), nn), zero, hn::Sub(one, s));
    return AddScaled(AddScaled(Lanes3<V>{hn::Neg(w.x), hn::Neg(w.y), hn::Neg(w.z)}, s, u), t, v);
}

/// A pair of triangles with what its separations and its distance need.
/// a, b: corners relative to a point near both, so that their rounding is that of small numbers.
template <class V>
struct TrianglePair {
    Triangles<V> a, b;
    Lanes3<V> edgeA[3], edgeB[3];
    Lanes3<V> spanA, spanB;  ///< corner 0 to corner 2
    Lanes3<V> normalA, normalB;

    HWY_INLINE TrianglePair(const Triangles<V>& first, const Triangles<V>& second) : a(first), b(second) {
        for (int k = 0; k < 3; ++k) {
            edgeA[k] = a.corner[(k + 1) % 3] - a.corner[k];
            edgeB[k] = b.corner[(k + 1) % 3] - b.corner[k];
        }
        spanA = a.corner[2] - a.corner[0];
        spanB = b.corner[2] - b.corner[0];
        normalA = Cross(edgeA[0], spanA);
        normalB = Cross(edgeB[0], spanB);
    }
};

/// A lower bound, but for rounding: the slabs across both normals, which is what parallel faces want.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V FaceSeparation(D d, const TrianglePair<V>& pair) {
    return hn::Max(SlabGap(d, pair.normalA, pair.a, pair.b), SlabGap(d, pair.normalB, pair.a, pair.b));
}

/// known: a lower bound of the pair already found.
template <class D, class V = hn::Vec<D>>
HWY_INLINE TriangleBounds<V> TriangleDistance(D d, const TrianglePair<V>& pair, V known) {
    const Triangles<V>&a = pair.a, &b = pair.b;
    Lanes3<V> best = b.corner[0] - a.corner[0];
    V bestSquared = Dot(best, best);
    V bestFeature = hn::Zero(d);
    const auto take = [&](const Lanes3<V>& v, int feature) HWY_ATTR {
        const V squared = Dot(v, v);
        const auto nearer = hn::Lt(squared, bestSquared);
        best = Select(nearer, v, best);
        bestFeature = hn::IfThenElse(nearer, hn::Set(d, hn::TFromD<D>(feature)), bestFeature);
        bestSquared = hn::IfThenElse(nearer, squared, bestSquared);
    };

    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            take(EdgeDifference(d, b.corner[j] - a.corner[i], pair.edgeA[i], pair.edgeB[j]), 3 * i + j);
        }
    }
    const V normalASquared = Dot(pair.normalA, pair.normalA),
            normalBSquared = Dot(pair.normalB, pair.normalB);
    for (int i = 0; i < 3; ++i) {
        take(FaceDifference(d, a.corner[i] - b.corner[0], pair.edgeB[0], pair.spanB, pair.normalB,
                            normalBSquared),
             9 + 2 * i);
        take(FaceDifference(d, b.corner[i] - a.corner[0], pair.edgeA[0], pair.spanA, pair.normalA,
                            normalASquared),
             10 + 2 * i);
    }
    return {hn::Max(SlabGap(d, best, a, b), known), hn::Sqrt(bestSquared), bestFeature};
}

}  // namespace HWY_NAMESPACE
}  // namespace clearway
HWY_AFTER_NAMESPACE();

#endif
