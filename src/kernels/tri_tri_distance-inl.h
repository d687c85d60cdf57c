// Distance of pairs of triangles, one pair per lane: an upper bound from two points of the triangles and a
// lower bound from slabs across the best directions.
//
// The closest points of two disjoint triangles lie on two edges (9 cases) or on a corner and the other face
// (6 cases). Edge pairs are solved with the cross product of the edges, which stays accurate for nearly
// parallel edges. The result is clamped and projected back and forth once, so that every difference scored is
// one of two points of the triangles. This kernel does not detect piercing: the lower bound of piercing
// triangles is not above 0, and double decides.
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
    V lower;               ///< slab gap: a lower bound up to rounding; may be negative
    V upper;               ///< distance of two points of the triangles: an upper bound up to rounding
    V feature;             ///< pair of features that holds these points, numbered as in query/pair_query.h
    Lanes3<V> difference;  ///< of these points, from the first triangle to the second or back
};

/// 1 / v, or 0 where v is not above 0. Float takes the processor's estimate and a Newton step: a share
/// computed with an inexact reciprocal still names a point of the edge.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V ReciprocalOrZero(D d, V v) {
#if HWY_TARGET != HWY_SCALAR
    if constexpr (sizeof(hn::TFromD<D>) == sizeof(float)) {
        constexpr int kNewtonSteps = HWY_ARCH_X86 ? 1 : 2;  // x86 estimates to 12 bits, others to 8
        V estimate = hn::ApproximateReciprocal(v);
        for (int step = 0; step < kNewtonSteps; ++step) {
            estimate = hn::Mul(estimate, hn::NegMulAdd(v, estimate, hn::Set(d, 2.0f)));
        }
        return hn::IfThenElseZero(hn::Gt(v, hn::Zero(d)), estimate);
    }
#endif
    return hn::IfThenElseZero(hn::Gt(v, hn::Zero(d)), hn::Div(hn::Set(d, hn::TFromD<D>(1)), v));
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE V ClampToUnit(D d, V v) {
    return hn::Clamp(v, hn::Zero(d), hn::Set(d, hn::TFromD<D>(1)));
}

/// Products of an edge u of a, an edge v of b and the vector w from the start of u to the start of v.
template <class V>
struct EdgeProducts {
    V uv, wu, wv;
    V uuReciprocal, vvReciprocal;
};

/// Difference q - p of the closest points, or nearly closest ones, of the edges p0 + s u and q0 + t v; s and
/// t in [0, 1], w = q0 - p0.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Lanes3<V> EdgeDifference(D d, const Lanes3<V>& w, const Lanes3<V>& u, const Lanes3<V>& v,
                                    const EdgeProducts<V>& of) {
    const Lanes3<V> n = Cross(u, v);
    V s = ClampToUnit(d, hn::Mul(Dot(Cross(w, v), n), ReciprocalOrZero(d, Dot(n, n))));
    const V t = ClampToUnit(d, hn::Mul(hn::MulSub(s, of.uv, of.wv), of.vvReciprocal));
    s = ClampToUnit(d, hn::Mul(hn::MulAdd(t, of.uv, of.wu), of.uuReciprocal));
    return AddScaled(AddScaled(w, t, v), hn::Neg(s), u);
}

/// Gradients of a triangle's barycentric coordinates: products with them give a point's shares of the edges u
/// and v.
template <class V>
struct FaceShares {
    Lanes3<V> ofU, ofV;
};

/// The triangle has the edges u and v; n = u x v.
template <class D, class V = hn::Vec<D>>
HWY_INLINE FaceShares<V> SharesOf(D d, const Lanes3<V>& u, const Lanes3<V>& v, const Lanes3<V>& n) {
    const V reciprocal = ReciprocalOrZero(d, Dot(n, n));
    const auto scaled = [&](const Lanes3<V>& a) HWY_ATTR {
        return Lanes3<V>{hn::Mul(a.x, reciprocal), hn::Mul(a.y, reciprocal), hn::Mul(a.z, reciprocal)};
    };
    return {scaled(Cross(v, n)), scaled(Cross(n, u))};
}

/// Difference p - q of a point p and its projection q onto the triangle q0 + s u + t v, clamped to the
/// triangle; w = p - q0.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Lanes3<V> FaceDifference(D d, const Lanes3<V>& w, const Lanes3<V>& u, const Lanes3<V>& v,
                                    const FaceShares<V>& shares) {
    const V s = ClampToUnit(d, Dot(w, shares.ofU));
    const V t = hn::Clamp(Dot(w, shares.ofV), hn::Zero(d), hn::Sub(hn::Set(d, hn::TFromD<D>(1)), s));
    return AddScaled(AddScaled(w, hn::Neg(s), u), hn::Neg(t), v);
}

/// A pair of triangles with the edges and normals that the bounds below need. a, b: corners relative to a
/// point near both triangles, so that rounding is in proportion to the pair's size.
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

/// A lower bound of the distance, up to rounding: the slab gaps across both normals, which suit parallel
/// faces.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V FaceSeparation(D d, const TrianglePair<V>& pair) {
    return hn::Max(SlabGap(d, pair.normalA, pair.a, pair.b), SlabGap(d, pair.normalB, pair.a, pair.b));
}

/// A lower bound of the distance, up to rounding: the widest slab gap across the 9 cross products of edges.
/// These and the normals of FaceSeparation are Gottschalk's 11 separating axes: two disjoint triangles that
/// are not coplanar have a separating direction among them. Coplanar pairs get no gap above 0 and are left to
/// double.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V EdgeSeparation(D d, const TrianglePair<V>& pair) {
    V gap = hn::Set(d, -hwy::HighestValue<float>());
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            gap = hn::Max(gap, SlabGap(d, Cross(pair.edgeA[i], pair.edgeB[j]), pair.a, pair.b));
        }
    }
    return gap;
}

/// Bounds of the pairs' distances. known: a lower bound of each pair that was found before.
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

    // A triangle's edges add up to 0 and w changes by one edge from pair to pair, so most products follow
    // from a few. The lost digits move points along their edges but not off them.
    V uu[3], vv[3], uv[3][3], wu[3][3], wv[3][3];
    for (int i = 0; i < 3; ++i) {
        uu[i] = ReciprocalOrZero(d, Dot(pair.edgeA[i], pair.edgeA[i]));
        vv[i] = ReciprocalOrZero(d, Dot(pair.edgeB[i], pair.edgeB[i]));
        uv[i][0] = Dot(pair.edgeA[i], pair.edgeB[0]);
        uv[i][1] = Dot(pair.edgeA[i], pair.edgeB[1]);
        uv[i][2] = hn::Neg(hn::Add(uv[i][0], uv[i][1]));
        wu[i][0] = Dot(b.corner[0] - a.corner[i], pair.edgeA[i]);
        wu[i][1] = hn::Add(wu[i][0], uv[i][0]);
        wu[i][2] = hn::Add(wu[i][1], uv[i][1]);
    }
    for (int j = 0; j < 3; ++j) {
        wv[0][j] = Dot(b.corner[j] - a.corner[0], pair.edgeB[j]);
        wv[1][j] = hn::Sub(wv[0][j], uv[0][j]);
        wv[2][j] = hn::Sub(wv[1][j], uv[1][j]);
    }
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            take(EdgeDifference(d, b.corner[j] - a.corner[i], pair.edgeA[i], pair.edgeB[j],
                                {uv[i][j], wu[i][j], wv[i][j], uu[i], vv[j]}),
                 3 * i + j);
        }
    }
    const FaceShares<V> sharesA = SharesOf(d, pair.edgeA[0], pair.spanA, pair.normalA),
                        sharesB = SharesOf(d, pair.edgeB[0], pair.spanB, pair.normalB);
    for (int k = 0; k < 3; ++k) {
        take(FaceDifference(d, a.corner[k] - b.corner[0], pair.edgeB[0], pair.spanB, sharesB), 9 + 2 * k);
        take(FaceDifference(d, b.corner[k] - a.corner[0], pair.edgeA[0], pair.spanA, sharesA), 10 + 2 * k);
    }
    return {hn::Max(SlabGap(d, best, a, b), known), hn::Sqrt(bestSquared), bestFeature, best};
}

}  // namespace HWY_NAMESPACE
}  // namespace clearway
HWY_AFTER_NAMESPACE();

#endif
