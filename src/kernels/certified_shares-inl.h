// Shares of half a piece of time for which a gap outlasts the speed at which it closes.
#include "hwy/highway.h"
#include "kernels/rounding.h"
#include "kernels/vector3-inl.h"

#if defined(CLEARWAY_KERNELS_CERTIFIED_SHARES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARWAY_KERNELS_CERTIFIED_SHARES_INL_H_
#undef CLEARWAY_KERNELS_CERTIFIED_SHARES_INL_H_
#else
#define CLEARWAY_KERNELS_CERTIFIED_SHARES_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace clearway {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Shares of the half pieces after and before the middle that are certified; above 0 where any is.
template <class V>
struct CertifiedShares {
    V after, before;

    HWY_INLINE void raise(V afterShare, V beforeShare) {
        after = hn::Max(after, afterShare);
        before = hn::Max(before, beforeShare);
    }
};

/// A share from this on stands for all of a half piece; what it is above 1 covers the rounding of comparisons.
constexpr float kWholeShare = 1 + 0x1p-20f;

/// excess / closing, and a large number where nothing comes closer; 0 where excess is not above 0 or not a number.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V ShareOf(D d, V excess, V closing) {
    const V share = hn::Div(excess, hn::Max(closing, hn::Set(d, 1e-30f)));
    return hn::IfThenElseZero(hn::And(hn::Gt(excess, hn::Zero(d)), hn::Ge(share, hn::Zero(d))), share);
}

/// The lanes that are certified throughout, as bits.
template <class D, class V = hn::Vec<D>>
HWY_INLINE std::uint32_t WholeLanes(D d, const CertifiedShares<V>& shares) {
    return MaskBits(d, hn::Ge(hn::Min(shares.after, shares.before), hn::Set(d, kWholeShare)));
}

/// Where a direction of squared length is long enough for closing speeds: the squares of turns across it must not vanish.
template <class D, class V = hn::Vec<D>>
HWY_INLINE hn::Mask<D> IsUsableToMove(D d, V lengthSquared) {
    return hn::And(hn::Gt(lengthSquared, hn::Set(d, kLeastMovingSquared)),
                   hn::Lt(lengthSquared, hn::Set(d, float(kLargestDirectionSquared))));
}

}  // namespace HWY_NAMESPACE
}  // namespace clearway
HWY_AFTER_NAMESPACE();

#endif
