// A direction's proof that two triangles are apart: the support gap. True for every direction, however it was
// found.
#include "hwy/highway.h"
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

/// One triangle per lane.
template <class V>
struct Triangles {
    Lanes3<V> corner[3];
};

/// Distance of the two slabs across v: max(min v.b - max v.a, min v.a - max v.b) / |v|, in the corners' unit;
/// -infinity where |v|^2 is not a normal number. Negative when the slabs overlap.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V SlabGap(D d, const Lanes3<V>& v, const Triangles<V>& a, const Triangles<V>& b) {
    const V a0 = Dot(v, a.corner[0]), a1 = Dot(v, a.corner[1]), a2 = Dot(v, a.corner[2]);
    const V b0 = Dot(v, b.corner[0]), b1 = Dot(v, b.corner[1]), b2 = Dot(v, b.corner[2]);
    const V aLow = hn::Min(a0, hn::Min(a1, a2)), aHigh = hn::Max(a0, hn::Max(a1, a2));
    const V bLow = hn::Min(b0, hn::Min(b1, b2)), bHigh = hn::Max(b0, hn::Max(b1, b2));
    const V lengthSquared = Dot(v, v);
    const V gap = hn::Div(hn::Max(hn::Sub(bLow, aHigh), hn::Sub(aLow, bHigh)), hn::Sqrt(lengthSquared));
    const auto usable =
        hn::And(hn::Gt(lengthSquared, hn::Set(d, 1e-30f)), hn::Lt(lengthSquared, hn::Set(d, 1e30f)));
    return hn::IfThenElse(usable, gap, hn::Set(d, -hwy::HighestValue<float>()));
}

}  // namespace HWY_NAMESPACE
}  // namespace clearway
HWY_AFTER_NAMESPACE();

#endif
