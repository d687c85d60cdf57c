// Loads the rows of framed_pairs.h into the kernels' registers.
#include "hwy/highway.h"
#include "kernels/certificate-inl.h"
#include "kernels/framed_pairs.h"

#if defined(CLEARWAY_TESTS_TRIANGLE_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARWAY_TESTS_TRIANGLE_LANES_INL_H_
#undef CLEARWAY_TESTS_TRIANGLE_LANES_INL_H_
#else
#define CLEARWAY_TESTS_TRIANGLE_LANES_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace clearway {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using WideTag = hn::CappedTag<float, testing::kVectorPairs>;

/// Appends one bool per lane.
template <class M>
void AppendLanes(M mask, std::vector<bool>& bools) {
    const WideTag d;
    const std::uint32_t bits = MaskBits(d, mask);
    for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane) bools.push_back((bits >> lane & 1) != 0);
}

/// Loads points from three rows that are `stride` numbers apart.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Lanes3<V> LoadPoints(D d, const hn::TFromD<D>* rows, std::size_t stride, std::size_t first) {
    return {hn::LoadU(d, rows + first), hn::LoadU(d, rows + stride + first),
            hn::LoadU(d, rows + 2 * stride + first)};
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE Triangles<V> LoadTriangles(D d, const std::vector<hn::TFromD<D>>& rows, std::size_t pairs,
                                      std::size_t first) {
    Triangles<V> triangles;
    for (std::size_t k = 0; k < 3; ++k) {
        triangles.corner[k] = LoadPoints(d, rows.data() + 3 * k * pairs, pairs, first);
    }
    return triangles;
}

}  // namespace HWY_NAMESPACE
}  // namespace clearway
HWY_AFTER_NAMESPACE();

#endif
