// Separation of pairs of triangles, one pair per lane: the widest slab gap over the 11 directions among which
// two disjoint triangles that are not coplanar have a separating one, both face normals and the 9 cross
// products of edges. Gottschalk's separating axes; the gap, not a sign, is what comes back, so that rounding
// can be taken from it. Coplanar pairs are left to the resolution in double: their gap is not above 0.
#include "hwy/highway.h"
#include "kernels/tri_tri_distance-inl.h"
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

/// Widest slab gap across the 9 cross products of edges: a lower bound of the distance but for rounding. Its
/// larger with FaceSeparation is above 0 exactly when one of the directions separates the two.
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

}  // namespace HWY_NAMESPACE
}  // namespace clearway
HWY_AFTER_NAMESPACE();

#endif
