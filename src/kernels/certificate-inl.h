// Proves that triangles are apart: the gap between them along a direction is a lower bound of their distance,
// whatever the direction and however it was found.
#include "hwy/highway.h"
#include "kernels/rounding.h"
#include "kernels/vector3-inl.h"

#if defined(CLEARWAY_KERNELS_CERTIFICATE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARWAY_KERNELS_CERTIFICATE_INL_H_
#undef CLEARWAY_KERNELS_CERTIFICATE_INL_H_
#else
#define CLEARWAY_KERNELS_CERTIFICATE_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace clearway {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The corners of triangles, one triangle per lane.
template <class V>
struct Triangles {
    Lanes3<V> corner[3];
};

/// The gap between the two triangles' slabs across v: max(min v.b - max v.a, min v.a - max v.b) / |v|, in the
/// corners' unit. Negative when the slabs overlap; -infinity where |v|^2 is too small or too large to be
/// used.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V SlabGap(D d, const Lanes3<V>& v, const Triangles<V>& a, const Triangles<V>& b) {
    const V a0 = Dot(v, a.corner[0]), a1 = Dot(v, a.corner[1]), a2 = Dot(v, a.corner[2]);
    const V b0 = Dot(v, b.corner[0]), b1 = Dot(v, b.corner[1]), b2 = Dot(v, b.corner[2]);
    const V aLow = hn::Min(a0, hn::Min(a1, a2)), aHigh = hn::Max(a0, hn::Max(a1, a2));
    const V bLow = hn::Min(b0, hn::Min(b1, b2)), bHigh = hn::Max(b0, hn::Max(b1, b2));
    const V lengthSquared = Dot(v, v);
    const V gap = hn::Div(hn::Max(hn::Sub(bLow, aHigh), hn::Sub(aLow, bHigh)), hn::Sqrt(lengthSquared));
    const auto usable = hn::And(hn::Gt(lengthSquared, hn::Set(d, hn::TFromD<D>(kLeastDirectionSquared))),
                                hn::Lt(lengthSquared, hn::Set(d, hn::TFromD<D>(kLargestDirectionSquared))));
    // A select and not a maximum, because instruction sets differ in the maximum of a NaN.
    return hn::IfThenElse(usable, gap, hn::Set(d, -hwy::HighestValue<hn::TFromD<D>>()));
}

/// One corner of each lane's triangle and the corner's coordinate along a direction.
template <class V>
struct SupportCorner {
    V along;  ///< v.corner
    Lanes3<V> corner;
};

/// Finds the corner farthest along v, or the least far with kNearest.
template <bool kNearest, class V>
HWY_INLINE SupportCorner<V> Support(const Lanes3<V>& v, const Triangles<V>& t) {
    SupportCorner<V> best = {Dot(v, t.corner[0]), t.corner[0]};
    for (int k = 1; k < 3; ++k) {
        const V along = Dot(v, t.corner[k]);
        const auto better = kNearest ? hn::Lt(along, best.along) : hn::Gt(along, best.along);
        best.along = hn::IfThenElse(better, along, best.along);
        best.corner = Select(better, t.corner[k], best.corner);
    }
    return best;
}

/// Whether a gap of `width` across v, in units of |v|, proves a distance of at least sqrt(needSquared). The
/// comparison is between squares, which saves the division. NaN proves nothing, nor does a v so short that
/// the squares might vanish. The comparison is strict, because the squares of lengths beyond 1e9 may both be
/// infinite.
template <class D, class V = hn::Vec<D>>
HWY_INLINE hn::Mask<D> ProvesApart(D d, V width, V lengthSquared, V needSquared) {
    const V positive = hn::Max(width, hn::Zero(d));
    return hn::And(hn::Gt(hn::Mul(positive, positive), hn::Mul(needSquared, lengthSquared)),
                   hn::Gt(lengthSquared, hn::Set(d, kLeastProvingSquared)));
}

/// apart^2, raised by the roundings of ProvesApart (see kNeedRoundoffs). apart: above 1e-7, in the corners'
/// unit.
inline float NeedSquared(float apart) {
    return apart * apart * (1 + kNeedRoundoffs * float(kUnitRoundoffFloat));
}

/// For triangles that do not move.
struct NoMove {
    static constexpr bool kIsNone = true;
    float nearingLeaves = 0;
};

/// Which pairs are proved to be at least sqrt(needSquared) apart, up to rounding, at a tenth of the cost of
/// their distance. Gilbert's walk starts at x, a difference of a point of b and a point of a, and goes kSteps
/// steps towards the least difference. The support gap across every point it passes is a lower bound,
/// whatever the point. move: pairs must stay apart while a moves; move.nearing(v, a) is how far any point of a
/// may move along v or against it, times |v|. Source: Gilbert, An Iterative Procedure for Computing the Minimum of a Quadratic Form
/// on a Convex Set, SIAM J. Control 4, 1966.
template <int kSteps, class D, class Move = NoMove, class V = hn::Vec<D>>
HWY_INLINE hn::Mask<D> WalkProvesApart(D d, const Triangles<V>& a, const Triangles<V>& b, Lanes3<V> x,
                                       V needSquared, const Move& move = {}) {
    auto proved = hn::MaskFromVec(hn::Zero(d));
#pragma GCC unroll 4
    for (int step = 0; step <= kSteps; ++step) {
        const SupportCorner<V> onA = Support<false>(x, a), onB = Support<true>(x, b);
        const V width = hn::Sub(onB.along, onA.along), lengthSquared = Dot(x, x);
        V kept = width;
        if constexpr (!Move::kIsNone) kept = hn::Sub(width, move.nearing(x, a));
        proved = hn::Or(proved, ProvesApart(d, kept, lengthSquared, needSquared));
        if (step == kSteps) break;
        // Walks from x towards the support point, as far as the segment between them comes nearest to 0. Any
        // share of the way is allowed, so an estimated quotient suffices. x . towards = width - x . x.
        const Lanes3<V> towards = onB.corner - onA.corner - x;
        const V share =
            hn::Mul(hn::Sub(lengthSquared, width), hn::ApproximateReciprocal(Dot(towards, towards)));
        x = AddScaled(x, hn::Clamp(share, hn::Zero(d), hn::Set(d, hn::TFromD<D>(1))), towards);
    }
    return proved;
}

}  // namespace HWY_NAMESPACE
}  // namespace clearway
HWY_AFTER_NAMESPACE();

#endif
