// 3D vectors, one per lane, as three vector registers of coordinates.
#include <cstdint>

#include "hwy/highway.h"

#if defined(CLEARWAY_KERNELS_VECTOR3_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARWAY_KERNELS_VECTOR3_INL_H_
#undef CLEARWAY_KERNELS_VECTOR3_INL_H_
#else
#define CLEARWAY_KERNELS_VECTOR3_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace clearway {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class V>
struct Lanes3 {
    V x, y, z;
};

template <class V>
HWY_INLINE Lanes3<V> operator+(const Lanes3<V>& a, const Lanes3<V>& b) {
    return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}

template <class V>
HWY_INLINE Lanes3<V> operator-(const Lanes3<V>& a, const Lanes3<V>& b) {
    return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}

/// a + s b.
template <class V>
HWY_INLINE Lanes3<V> AddScaled(const Lanes3<V>& a, V s, const Lanes3<V>& b) {
    return {hn::MulAdd(s, b.x, a.x), hn::MulAdd(s, b.y, a.y), hn::MulAdd(s, b.z, a.z)};
}

template <class V>
HWY_INLINE V Dot(const Lanes3<V>& a, const Lanes3<V>& b) {
    return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z)));
}

template <class V>
HWY_INLINE Lanes3<V> Cross(const Lanes3<V>& a, const Lanes3<V>& b) {
    return {hn::MulSub(a.y, b.z, hn::Mul(a.z, b.y)), hn::MulSub(a.z, b.x, hn::Mul(a.x, b.z)),
            hn::MulSub(a.x, b.y, hn::Mul(a.y, b.x))};
}

template <class V, class M>
HWY_INLINE Lanes3<V> Select(M mask, const Lanes3<V>& yes, const Lanes3<V>& no) {
    return {hn::IfThenElse(mask, yes.x, no.x), hn::IfThenElse(mask, yes.y, no.y),
            hn::IfThenElse(mask, yes.z, no.z)};
}

/// The mask as bits: bit k is set when lane k is. At most 16 lanes.
template <class D, class M>
HWY_INLINE std::uint32_t MaskBits(D d, M mask) {
    alignas(8) std::uint8_t bytes[8] = {};  // StoreMaskBits may write up to 8
    hn::StoreMaskBits(d, mask, bytes);
    return std::uint32_t(bytes[0]) | std::uint32_t(bytes[1]) << 8;
}

/// Position of the lowest set bit. bits: not 0.
HWY_INLINE std::uint32_t LowestBit(std::uint32_t bits) {
    return std::uint32_t(__builtin_ctz(bits));
}

}  // namespace HWY_NAMESPACE
}  // namespace clearway
HWY_AFTER_NAMESPACE();

#endif
