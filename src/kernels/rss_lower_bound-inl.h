// Lower bounds of the distance between one RSS and the children of a wide node, one child per lane.
//
// The bound is a lower bound of the rectangles' distance less both radii: the larger of the box gaps in both
// rectangles' frames and one support gap. The support gap's direction is found in one of two ways:
//  - cheap: by alternating projections between the rectangles;
//  - exact: as the difference of the closest points over all pairs of edges and all corners and faces. This
//    gives the rectangles' distance up to rounding. It is the test of Ytterlid's thesis, which node width 2
//    keeps for comparison; kIsExact chooses it for other widths.
// The support gap (min v.q - max v.p) / |v| is a true lower bound for ANY direction v, so a badly conditioned
// closest pair makes the bound loose, never false. A computed closest distance is not a lower bound and is
// never used as one.
//
// Source of the volume: Larsen et al., Fast Proximity Queries with Swept Sphere Volumes, TR99-018, 1999.
#include "hwy/highway.h"
#include "kernels/rounding.h"
#include "kernels/vector3-inl.h"
#include "tree/flat_tree.h"

#if defined(CLEARWAY_KERNELS_RSS_LOWER_BOUND_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARWAY_KERNELS_RSS_LOWER_BOUND_INL_H_
#undef CLEARWAY_KERNELS_RSS_LOWER_BOUND_INL_H_
#else
#define CLEARWAY_KERNELS_RSS_LOWER_BOUND_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace clearway {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// One RSS carried into the frame and unit of the node it is tested against.
struct CarriedRss {
    float centre[4];  ///< x, y, z and an unused float
    float axis0[4];
    float axis1[4];  ///< laid out like the centre
    float halfLength0;
    float halfLength1;
    float radius;
};

/// The lanes' rectangles in the frame of the one rectangle that all are tested against, which is centred at 0
/// and has its sides along x and y.
template <class V>
struct RelativeRectangles {
    Lanes3<V> centre;
    Lanes3<V> side0, side1, normal;
    V half0, half1;  ///< half lengths of the lanes' rectangles
    V H0, H1;        ///< half lengths of the one rectangle
};

/// The slabs of the rectangles across a direction v: |v| times the gap along v is |along| - reach.
template <class V>
struct Slabs {
    V along;  ///< v . centre
    V reach;
    V lengthSquared;  ///< |v|^2
};

template <class V>
HWY_INLINE Slabs<V> SlabsAcross(const Lanes3<V>& v, const RelativeRectangles<V>& r) {
    auto reach = hn::Mul(hn::Abs(v.x), r.H0);
    reach = hn::MulAdd(hn::Abs(v.y), r.H1, reach);
    reach = hn::MulAdd(hn::Abs(Dot(v, r.side0)), r.half0, reach);
    reach = hn::MulAdd(hn::Abs(Dot(v, r.side1)), r.half1, reach);
    return {Dot(v, r.centre), reach, Dot(v, v)};
}

/// Where |v|^2 is neither too small nor too large to be used.
template <class D, class V = hn::Vec<D>>
HWY_INLINE hn::Mask<D> IsUsable(D d, V lengthSquared) {
    return hn::And(hn::Gt(lengthSquared, hn::Set(d, float(kLeastDirectionSquared))),
                   hn::Lt(lengthSquared, hn::Set(d, float(kLargestDirectionSquared))));
}

/// The gap along v between the rectangles: (min over one of v.x - max over the other of v.x) / |v|. -infinity
/// where |v|^2 is too small or too large to be used.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V SupportGap(D d, const Lanes3<V>& v, const RelativeRectangles<V>& r) {
    const Slabs<V> slabs = SlabsAcross(v, r);
    const auto gap = hn::Div(hn::Sub(hn::Abs(slabs.along), slabs.reach), hn::Sqrt(slabs.lengthSquared));
    // A select and not a maximum, because instruction sets differ in the maximum of a NaN.
    return hn::IfThenElse(IsUsable(d, slabs.lengthSquared), gap, hn::Set(d, -hwy::HighestValue<float>()));
}

/// The distance of the boxes around both rectangles, aligned with the one rectangle's frame or with the
/// lane's: the larger of the two.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V BoxGap(D d, const RelativeRectangles<V>& r) {
    const auto zero = hn::Zero(d);
    const auto gap = [&](V along, V extent)
                         HWY_ATTR { return hn::Max(hn::Sub(hn::Abs(along), extent), zero); };
    const auto extent = [&](V alongSide0, V alongSide1) HWY_ATTR {
        return hn::MulAdd(hn::Abs(alongSide0), r.half0, hn::Mul(hn::Abs(alongSide1), r.half1));
    };
    const Lanes3<V> own = {gap(r.centre.x, hn::Add(extent(r.side0.x, r.side1.x), r.H0)),
                           gap(r.centre.y, hn::Add(extent(r.side0.y, r.side1.y), r.H1)),
                           gap(r.centre.z, extent(r.side0.z, r.side1.z))};
    const auto reach = [&](const Lanes3<V>& axis) HWY_ATTR {
        return hn::MulAdd(hn::Abs(axis.x), r.H0, hn::Mul(hn::Abs(axis.y), r.H1));
    };
    const Lanes3<V> theirs = {gap(Dot(r.side0, r.centre), hn::Add(reach(r.side0), r.half0)),
                              gap(Dot(r.side1, r.centre), hn::Add(reach(r.side1), r.half1)),
                              gap(Dot(r.normal, r.centre), reach(r.normal))};
    return hn::Sqrt(hn::Max(Dot(own, own), Dot(theirs, theirs)));
}

/// Projects the one's centre onto the lane's rectangle, back onto the one, and so on for two rounds. Returns
/// the difference of the last two points.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Lanes3<V> AlternatingDirection(D d, const RelativeRectangles<V>& r) {
    const auto zero = hn::Zero(d);
    Lanes3<V> onOne = {zero, zero, zero};
    Lanes3<V> onLane = r.centre;
    for (int round = 0; round < 2; ++round) {
        const auto fromCentre = onOne - r.centre;
        const auto along0 = hn::Clamp(Dot(fromCentre, r.side0), hn::Neg(r.half0), r.half0);
        const auto along1 = hn::Clamp(Dot(fromCentre, r.side1), hn::Neg(r.half1), r.half1);
        onLane = AddScaled(AddScaled(r.centre, along0, r.side0), along1, r.side1);
        onOne = {hn::Clamp(onLane.x, hn::Neg(r.H0), r.H0), hn::Clamp(onLane.y, hn::Neg(r.H1), r.H1), zero};
    }
    return onLane - onOne;
}

/// The shortest difference over all pairs of edges of the two rectangles, and each corner with the other
/// face.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Lanes3<V> ClosestDirection(D d, const RelativeRectangles<V>& r) {
    const auto zero = hn::Zero(d);
    const auto one = hn::Set(d, 1.0f);
    Lanes3<V> best = r.centre;
    V bestSquared = hn::Set(d, hwy::HighestValue<float>());
    const auto take = [&](const Lanes3<V>& v) HWY_ATTR {
        const auto squared = Dot(v, v);
        const auto nearer = hn::Lt(squared, bestSquared);
        best = Select(nearer, v, best);
        bestSquared = hn::IfThenElse(nearer, squared, bestSquared);
    };
    const auto signedHalf = [&](int side, V half) HWY_ATTR { return side == 0 ? half : hn::Neg(half); };

    for (int ownAxis = 0; ownAxis < 2; ++ownAxis) {
        const V ownHalf = ownAxis == 0 ? r.H0 : r.H1;
        for (int laneAxis = 0; laneAxis < 2; ++laneAxis) {
            const Lanes3<V>& direction = laneAxis == 0 ? r.side0 : r.side1;
            const Lanes3<V>& across = laneAxis == 0 ? r.side1 : r.side0;
            const V half = laneAxis == 0 ? r.half0 : r.half1;
            const V halfAcross = laneAxis == 0 ? r.half1 : r.half0;
            const V cosine = ownAxis == 0 ? direction.x : direction.y;
            const V sineSquared = hn::NegMulAdd(cosine, cosine, one);
            for (int sides = 0; sides < 4; ++sides) {
                // w goes from the middle of the one's edge to the middle of the lane's edge.
                const V offset = signedHalf(sides & 1, ownAxis == 0 ? r.H1 : r.H0);
                Lanes3<V> w = AddScaled(r.centre, signedHalf(sides >> 1, halfAcross), across);
                (ownAxis == 0 ? w.y : w.x) = hn::Sub(ownAxis == 0 ? w.y : w.x, offset);
                const V wOwn = ownAxis == 0 ? w.x : w.y;
                const V wLane = Dot(w, direction);
                const V start = hn::Div(hn::NegMulAdd(cosine, wLane, wOwn), sineSquared);
                V s = hn::IfThenElse(hn::Gt(sineSquared, hn::Set(d, 1e-12f)), start, zero);
                s = hn::Clamp(s, hn::Neg(ownHalf), ownHalf);
                const V t = hn::Clamp(hn::MulSub(s, cosine, wLane), hn::Neg(half), half);
                s = hn::Clamp(hn::MulAdd(t, cosine, wOwn), hn::Neg(ownHalf), ownHalf);
                Lanes3<V> v = AddScaled(w, t, direction);
                (ownAxis == 0 ? v.x : v.y) = hn::Sub(ownAxis == 0 ? v.x : v.y, s);
                take(v);
            }
        }
    }
    for (int corner = 0; corner < 4; ++corner) {
        const Lanes3<V> onLane = AddScaled(AddScaled(r.centre, signedHalf(corner & 1, r.half0), r.side0),
                                           signedHalf(corner >> 1, r.half1), r.side1);
        take({hn::Sub(onLane.x, hn::Clamp(onLane.x, hn::Neg(r.H0), r.H0)),
              hn::Sub(onLane.y, hn::Clamp(onLane.y, hn::Neg(r.H1), r.H1)), onLane.z});
        const Lanes3<V> onOne = {signedHalf(corner & 1, r.H0), signedHalf(corner >> 1, r.H1), zero};
        const auto fromCentre = onOne - r.centre;
        const auto along0 = hn::Clamp(Dot(fromCentre, r.side0), hn::Neg(r.half0), r.half0);
        const auto along1 = hn::Clamp(Dot(fromCentre, r.side1), hn::Neg(r.half1), r.half1);
        take(AddScaled(AddScaled(r.centre, along0, r.side0), along1, r.side1) - onOne);
    }
    return best;
}

/// The frame of the one rectangle: its centre is the origin, its sides are x and y. Every lane is the same.
template <class V>
struct OneFrame {
    Lanes3<V> centre, x, y, z;

    template <class D>
    HWY_INLINE OneFrame(D d, const CarriedRss& one) : centre(splat(d, one.centre)), x(splat(d, one.axis0)) {
        y = splat(d, one.axis1);
        z = Cross(x, y);
    }
    template <class D>
    static HWY_INLINE Lanes3<V> splat(D d, const float (&p)[4]) {
        return {hn::Set(d, p[0]), hn::Set(d, p[1]), hn::Set(d, p[2])};
    }
    HWY_INLINE Lanes3<V> toOne(const Lanes3<V>& v) const { return {Dot(x, v), Dot(y, v), Dot(z, v)}; }
};

/// The rectangles of the children from lane i on, relative to the one.
template <int kWidth, class D, class V = hn::Vec<D>>
HWY_INLINE RelativeRectangles<V> RelativeTo(D d, const OneFrame<V>& frame, const CarriedRss& one,
                                            const WideNode<kWidth>& node, size_t i) {
    const auto load3 = [&](const float(&rows)[3][kWidth]) HWY_ATTR {
        return Lanes3<V>{hn::Load(d, rows[0] + i), hn::Load(d, rows[1] + i), hn::Load(d, rows[2] + i)};
    };
    RelativeRectangles<V> r;
    r.centre = frame.toOne(load3(node.centre) - frame.centre);
    r.side0 = frame.toOne(load3(node.axis0));
    r.side1 = frame.toOne(load3(node.axis1));
    r.normal = Cross(r.side0, r.side1);
    r.half0 = hn::Load(d, node.halfLength0 + i);
    r.half1 = hn::Load(d, node.halfLength1 + i);
    r.H0 = hn::Set(d, one.halfLength0);
    r.H1 = hn::Set(d, one.halfLength1);
    return r;
}

/// The lanes from i on that hold a child, as bits.
template <int kWidth, class D>
HWY_INLINE std::uint32_t UsedLanes(D d, const WideNode<kWidth>& node, size_t i) {
    const hn::RebindToSigned<D> di;
    (void)d;
    return MaskBits(di, hn::Ne(hn::Load(di, node.child + i), hn::Set(di, kNoChild)));
}

struct NearChildren {
    std::uint32_t lanes;     ///< bit k is set when child k's bound is below dropFrom, or not a number
    std::uint32_t children;  ///< number of lanes in use
};

/// Lower bounds from one RSS to the kWidth children of a node. one: in the node's frame and unit.  slack:
/// subtracted from every bound, in the node's unit; kVolumeSlack covers the rounding of everything done here.
/// toQueryUnit: an exact power of two, node unit -> query unit.  dropFrom: query units. bounds: the bounds of
/// the near lanes, in query units, none above the true distance. They are negative when the volumes overlap
/// and stay so, because they order the descent. The other lanes' bounds have no meaning.
template <int kWidth, bool kIsExact = kWidth == 2>
HWY_INLINE NearChildren RssLowerBounds(const CarriedRss& one, const WideNode<kWidth>& node, float slack,
                                       float toQueryUnit, float dropFrom, float* bounds) {
    const hn::CappedTag<float, kWidth> d;
    using V = hn::Vec<decltype(d)>;
    std::uint32_t near = 0, children = 0;
    for (size_t i = 0; i < kWidth; i += hn::Lanes(d)) {
        const OneFrame<V> frame(d, one);
        const RelativeRectangles<V> r = RelativeTo(d, frame, one, node, i);
        const auto radii = hn::Add(hn::Load(d, node.radius + i), hn::Set(d, one.radius + slack));
        const auto unit = hn::Set(d, toQueryUnit), limit = hn::Set(d, dropFrom);
        const std::uint32_t used = UsedLanes(d, node, i);
        children += std::uint32_t(hwy::PopCount(used));
        const auto boxGap = BoxGap(d, r);
        auto bound = hn::Mul(hn::Sub(boxGap, radii), unit);
        // In half of the visits the box gaps drop all children.
        if ((used & ~MaskBits(d, hn::Ge(bound, limit))) == 0) continue;
        const auto direction = kIsExact ? ClosestDirection(d, r) : AlternatingDirection(d, r);
        bound = hn::Mul(hn::Sub(hn::Max(boxGap, SupportGap(d, direction, r)), radii), unit);
        hn::StoreU(bound, d, bounds + i);
        near |= (used & ~MaskBits(d, hn::Ge(bound, limit))) << i;
    }
    return {near, children};
}

}  // namespace HWY_NAMESPACE
}  // namespace clearway
HWY_AFTER_NAMESPACE();

#endif
