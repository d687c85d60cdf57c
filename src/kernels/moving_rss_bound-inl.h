// How long the children of a wide node stay apart from one RSS while the part moves, one child per lane.
//
// The part moves by a velocity field that is affine in place, V(y) = V0 + W x y, plus a deviation of known size. Along a
// direction n from the part to the environment no point of a volume of the part comes closer than the largest n.V of the
// volume. So the gap along n outlasts a time that is the gap divided by that closing speed. Speeds here are lengths moved
// in half a piece of time, so the quotient is the share of the half piece that is certified. Three bounds are taken: the
// larger of all gaps against the volume's whole speed, the gap along the support direction against the speed along it, and
// the gap across a direction at a right angle to the velocity, which outlasts sliding along a face.
#include "hwy/highway.h"
#include "kernels/certified_shares-inl.h"
#include "kernels/moved_field.h"
#include "kernels/rss_lower_bound-inl.h"

#if defined(CLEARWAY_KERNELS_MOVING_RSS_BOUND_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARWAY_KERNELS_MOVING_RSS_BOUND_INL_H_
#undef CLEARWAY_KERNELS_MOVING_RSS_BOUND_INL_H_
#else
#define CLEARWAY_KERNELS_MOVING_RSS_BOUND_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace clearway {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The lanes' velocities in the one's frame.
template <class V>
struct LaneVelocities {
    Lanes3<V> centre;  ///< of the centre of the part's volume
    Lanes3<V> turn;
    V deviation, bow;
};

/// Certifies along v. kLanesMove: the lanes' volumes are the part's, otherwise the one is. radii: both radii, the slack and
/// the gap that is needed. movingRadius: of the part's volume.
template <bool kLanesMove, class D, class V = hn::Vec<D>>
HWY_INLINE void CertifyAlong(D d, const Lanes3<V>& v, const RelativeRectangles<V>& r, V radii, V movingRadius,
                             const LaneVelocities<V>& velocity, CertifiedShares<V>& shares) {
    const Slabs<V> slabs = SlabsAcross(v, r);
    const V length = hn::Sqrt(slabs.lengthSquared);
    const V excess = hn::NegMulAdd(length, radii, hn::Sub(hn::Abs(slabs.along), slabs.reach));
    const Lanes3<V> spin = Cross(v, velocity.turn);
    V spread = hn::MulAdd(length, velocity.deviation,
                          hn::Mul(hn::Sqrt(Dot(spin, spin)), hn::Add(movingRadius, velocity.bow)));
    if constexpr (kLanesMove) {
        spread = hn::MulAdd(hn::Abs(Dot(spin, r.side0)), r.half0, spread);
        spread = hn::MulAdd(hn::Abs(Dot(spin, r.side1)), r.half1, spread);
    } else {
        spread = hn::MulAdd(hn::Abs(spin.x), r.H0, spread);
        spread = hn::MulAdd(hn::Abs(spin.y), r.H1, spread);
    }
    // v or -v points from the one to the lane.
    const V towardsLane = hn::Xor(Dot(v, velocity.centre), hn::And(slabs.along, hn::Set(d, -0.0f)));
    const V closing = kLanesMove ? hn::Neg(towardsLane) : towardsLane;
    const V usableExcess = hn::IfThenElseZero(IsUsableToMove(d, slabs.lengthSquared), excess);
    shares.raise(ShareOf(d, usableExcess, hn::Add(spread, closing)),
                 ShareOf(d, usableExcess, hn::Sub(spread, closing)));
}

/// The gaps and shares of a node's children.
template <int kWidth>
struct MovingBounds {
    alignas(64) float gap[kWidth];  ///< orders the children by their distances at the middle; query units
    alignas(64) float after[kWidth];
    alignas(64) float before[kWidth];
    alignas(64) float moved[kWidth];  ///< how far a point moves in half the piece at most, query units
};

/// Bounds how long the node's children stay farther than `need` from the one. kLanesMove: the node is of the part's tree,
/// otherwise the one is. one, field: in the node's frame and unit. slack, toQueryUnit: as in RssLowerBounds. need: query
/// units. Returns the lanes that are not certified throughout; the others' bounds have no meaning.
template <bool kLanesMove, int kWidth>
HWY_INLINE NearChildren MovingRssBounds(const CarriedRss& one, const WideNode<kWidth>& node,
                                        const MovedField& field, float slack, float toQueryUnit, float need,
                                        MovingBounds<kWidth>& bounds) {
    const hn::CappedTag<float, kWidth> d;
    using V = hn::Vec<decltype(d)>;
    const float needHere = need / toQueryUnit;  // exact: a power of two
    std::uint32_t near = 0, children = 0;
    for (size_t i = 0; i < kWidth; i += hn::Lanes(d)) {
        const OneFrame<V> frame(d, one);
        const RelativeRectangles<V> r = RelativeTo(d, frame, one, node, i);
        const V radius = hn::Load(d, node.radius + i);
        const V radii = hn::Add(radius, hn::Set(d, one.radius + slack + needHere));
        const V movingRadius = kLanesMove ? radius : hn::Set(d, one.radius);

        const Lanes3<V> turn = OneFrame<V>::splat(d, field.turn);
        LaneVelocities<V> velocity;
        velocity.turn = frame.toOne(turn);
        velocity.centre = frame.toOne(OneFrame<V>::splat(d, field.atOrigin) + Cross(turn, frame.centre));
        if constexpr (kLanesMove) velocity.centre = velocity.centre + Cross(velocity.turn, r.centre);
        velocity.deviation = hn::Set(d, field.deviation);
        velocity.bow = hn::Set(d, field.bow);

        const std::uint32_t used = UsedLanes(d, node, i);
        children += std::uint32_t(hwy::PopCount(used));
        const V half0 = kLanesMove ? r.half0 : r.H0, half1 = kLanesMove ? r.half1 : r.H1;
        const V arm = hn::Add(hn::Sqrt(hn::MulAdd(half0, half0, hn::Mul(half1, half1))),
                              hn::Add(movingRadius, velocity.bow));
        const V speed = hn::Sqrt(Dot(velocity.centre, velocity.centre));
        const V moved =
            hn::Add(hn::MulAdd(hn::Sqrt(Dot(velocity.turn, velocity.turn)), arm, speed), velocity.deviation);
        V gap = BoxGap(d, r);
        V plain = ShareOf(d, hn::Sub(gap, radii), moved);
        if ((used & ~MaskBits(d, hn::Ge(plain, hn::Set(d, kWholeShare)))) == 0) continue;

        const Lanes3<V> direction = kWidth == 2 ? ClosestDirection(d, r) : AlternatingDirection(d, r);
        gap = hn::Max(gap, SupportGap(d, direction, r));
        plain = ShareOf(d, hn::Sub(gap, radii), moved);
        CertifiedShares<V> shares = {plain, plain};
        CertifyAlong<kLanesMove>(d, direction, r, radii, movingRadius, velocity, shares);
        if ((used & ~WholeLanes(d, shares)) == 0) continue;
        const V along = hn::Div(Dot(direction, velocity.centre), Dot(velocity.centre, velocity.centre));
        CertifyAlong<kLanesMove>(d, AddScaled(direction, hn::Neg(along), velocity.centre), r, radii,
                                 movingRadius, velocity, shares);
        near |= (used & ~WholeLanes(d, shares)) << i;
        hn::StoreU(hn::Mul(hn::Sub(gap, radius), hn::Set(d, toQueryUnit)), d, bounds.gap + i);
        hn::StoreU(hn::Mul(moved, hn::Set(d, toQueryUnit)), d, bounds.moved + i);
        hn::StoreU(shares.after, d, bounds.after + i);
        hn::StoreU(shares.before, d, bounds.before + i);
    }
    return {near, children};
}

}  // namespace HWY_NAMESPACE
}  // namespace clearway
HWY_AFTER_NAMESPACE();

#endif
