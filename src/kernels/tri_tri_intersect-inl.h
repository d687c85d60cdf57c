// Separation of pairs of triangles, one pair per lane: the widest slab gap over the 11 directions among which
// two disjoint triangles that are not coplanar have a separating one, both face normals and the 9 cross
// products of edges. Gottschalk's separating axes; the gap, not a sign, is what comes back, so that rounding
// can be taken from it. Coplanar pairs are left to the resolution in double: their gap is not above 0.
#include "hwy/highway.h"
#include "kernels/certificate-inl.h"
#include "kernels/vector3-inl.h"

#if defined(CLEARWAY_KERNELS_TRI_TRI_INTERSECT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARWAY_KERNELS_TRI_TRI_INTERSECT_INL_H_
#undef CLEARWAY_KERNELS_TRI_TRI_INTERSECT_INL_H_
#else
#define CLEARWAY_KERNELS_TRI_TRI_INTERSECT_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace clearway {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// A lower bound of the distance but for rounding; above 0 exactly when a direction separates the two.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V TriangleSeparation(D d, const Triangles<V>& a, const Triangles<V>& b) {
    Lanes3<V> edgeA[3], edgeB[3];
    for (int k = 0; k < 3; ++k) {
        edgeA[k] = a.corner[(k + 1) % 3] - a.corner[k];
        edgeB[k] = b.corner[(k + 1) % 3] - b.corner[k];
    }
    V gap = SlabGap(d, Cross(edgeA[0], edgeA[1]), a, b);
    gap = hn::Max(gap, SlabGap(d, Cross(edgeB[0], edgeB[1]), a, b));
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) gap = hn::Max(gap, SlabGap(d, Cross(edgeA[i], edgeB[j]), a, b));
    }
    return gap;
}

}  // namespace HWY_NAMESPACE
}  // namespace clearway
HWY_AFTER_NAMESPACE();

#endif
