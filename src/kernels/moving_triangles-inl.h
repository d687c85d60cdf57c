// How long pairs of triangles stay apart while one of each pair moves, one pair per lane. The idea and its terms are those
// of moving_rss_bound-inl.h: along a direction, a gap outlasts the speed at which the corners close it.
#include "hwy/highway.h"
#include "kernels/certified_shares-inl.h"
#include "kernels/moved_field.h"
#include "kernels/tri_tri_distance-inl.h"

#if defined(CLEARWAY_KERNELS_MOVING_TRIANGLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARWAY_KERNELS_MOVING_TRIANGLES_INL_H_
#undef CLEARWAY_KERNELS_MOVING_TRIANGLES_INL_H_
#else
#define CLEARWAY_KERNELS_MOVING_TRIANGLES_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace clearway {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// How far triangles move along one direction v in half a piece, times |v|.
template <class V>
struct MovesAlong {
    V corner[3];
    V bow;  ///< to either side, on top of the corners' moves
};

/// The field by which the triangles `a` of pairs move, in the frame and unit of their corners.
template <class V>
struct TriangleField {
    template <class D>
    HWY_INLINE TriangleField(D d, const MovedField& field)
        : atOrigin{hn::Set(d, field.atOrigin[0]), hn::Set(d, field.atOrigin[1]),
                   hn::Set(d, field.atOrigin[2])},
          turn{hn::Set(d, field.turn[0]), hn::Set(d, field.turn[1]), hn::Set(d, field.turn[2])},
          deviation(hn::Set(d, field.deviation)),
          bow(hn::Set(d, field.bow)) {}

    HWY_INLINE MovesAlong<V> along(const Lanes3<V>& v, const Triangles<V>& a) const {
        const V origin = Dot(v, atOrigin);
        const Lanes3<V> across = Cross(v, turn);  // v . (turn x corner) = across . corner
        MovesAlong<V> moves;
        for (int k = 0; k < 3; ++k) moves.corner[k] = hn::Add(origin, Dot(across, a.corner[k]));
        moves.bow = hn::Mul(hn::Sqrt(Dot(across, across)), bow);
        return moves;
    }

    /// Three times the move of the triangles' centres.
    HWY_INLINE Lanes3<V> ofCentres(const Triangles<V>& a) const {
        return atOrigin + atOrigin + atOrigin + Cross(turn, a.corner[0] + a.corner[1] + a.corner[2]);
    }

    Lanes3<V> atOrigin, turn;
    V deviation, bow;
};

/// A move for WalkProvesApart: that of the part's leaf, of two leaves whose triangles are paired.
struct LeafMove {
    static constexpr bool kIsNone = false;

    /// between, radius: the centre of the part's leaf in the field's frame, and the leaf's radius.
    HWY_INLINE LeafMove(const MovedField& theField, const float (&between)[3], float radius)
        : field(theField) {
        const float *v = field.atOrigin, *w = field.turn, *o = between;
        const float spin[3] = {w[1] * o[2] - w[2] * o[1], w[2] * o[0] - w[0] * o[2],
                               w[0] * o[1] - w[1] * o[0]};
        const float along = v[0] * o[0] + v[1] * o[1] + v[2] * o[2];
        const float across = __builtin_sqrtf(spin[0] * spin[0] + spin[1] * spin[1] + spin[2] * spin[2]);
        nearingLeaves = __builtin_fabsf(along) + across * (radius + field.bow);
    }

    template <class V>
    HWY_INLINE V nearing(const Lanes3<V>& v, const Triangles<V>& a) const {
        const MovesAlong<V> moves = TriangleField<V>(hn::DFromV<V>(), field).along(v, a);
        return hn::Add(
            hn::Max(hn::Abs(moves.corner[0]), hn::Max(hn::Abs(moves.corner[1]), hn::Abs(moves.corner[2]))),
            moves.bow);
    }

    const MovedField& field;
    /// How far any point of the part's leaf moves along the line between the leaves' centres, times the line's length.
    float nearingLeaves;
};

/// Shares certified for pairs of triangles, with bounds of the pairs' distances at the middle, up to rounding.
template <class V>
struct MovingTriangles {
    CertifiedShares<V> shares;
    std::uint32_t left;        ///< the lanes that the normals do not certify, as bits
    TriangleBounds<V> bounds;  ///< not set if none is left
};

/// Certifies pairs along v and raises `lower` to the gap found. need: the gap that must remain.
template <class D, class V = hn::Vec<D>>
HWY_INLINE void CertifyTrianglesAlong(D d, const Lanes3<V>& v, const TrianglePair<V>& pair, V need,
                                      const TriangleField<V>& field, V& lower, CertifiedShares<V>& shares) {
    const V a0 = Dot(v, pair.a.corner[0]), a1 = Dot(v, pair.a.corner[1]), a2 = Dot(v, pair.a.corner[2]);
    const V b0 = Dot(v, pair.b.corner[0]), b1 = Dot(v, pair.b.corner[1]), b2 = Dot(v, pair.b.corner[2]);
    const V above = hn::Sub(hn::Min(b0, hn::Min(b1, b2)), hn::Max(a0, hn::Max(a1, a2)));
    const V below = hn::Sub(hn::Min(a0, hn::Min(a1, a2)), hn::Max(b0, hn::Max(b1, b2)));
    const auto isAbove = hn::Ge(above, below);
    const V lengthSquared = Dot(v, v);
    const V inverse = hn::Div(hn::Set(d, 1.0f), hn::Sqrt(lengthSquared));
    const V gap = hn::IfThenElse(IsUsableToMove(d, lengthSquared),
                                 hn::Mul(hn::IfThenElse(isAbove, above, below), inverse),
                                 hn::Set(d, -hwy::HighestValue<float>()));
    lower = hn::Max(lower, gap);
    const MovesAlong<V> moves = field.along(v, pair.a);
    const V up = hn::Max(moves.corner[0], hn::Max(moves.corner[1], moves.corner[2]));
    const V down = hn::Neg(hn::Min(moves.corner[0], hn::Min(moves.corner[1], moves.corner[2])));
    const V after = hn::Add(hn::IfThenElse(isAbove, up, down), moves.bow);
    const V before = hn::Add(hn::IfThenElse(isAbove, down, up), moves.bow);
    const V excess = hn::Sub(gap, need);
    shares.raise(ShareOf(d, excess, hn::MulAdd(after, inverse, field.deviation)),
                 ShareOf(d, excess, hn::MulAdd(before, inverse, field.deviation)));
}

/// Certifies pairs along both normals and, unless that is enough, along the line of their least distance and along that
/// line turned square to their velocity. near: the lanes in question, as bits.
template <class D, class V = hn::Vec<D>>
HWY_INLINE MovingTriangles<V> CertifyMovingTriangles(D d, const TrianglePair<V>& pair, std::uint32_t near,
                                                     V need, const TriangleField<V>& field) {
    MovingTriangles<V> answer;
    answer.shares = {hn::Zero(d), hn::Zero(d)};
    V lower = hn::Set(d, -hwy::HighestValue<float>());
    CertifyTrianglesAlong(d, pair.normalA, pair, need, field, lower, answer.shares);
    CertifyTrianglesAlong(d, pair.normalB, pair, need, field, lower, answer.shares);
    answer.left = near & ~WholeLanes(d, answer.shares);
    if (answer.left == 0) return answer;
    answer.bounds = TriangleDistance(d, pair, lower);
    const Lanes3<V>& apart = answer.bounds.difference;
    CertifyTrianglesAlong(d, apart, pair, need, field, lower, answer.shares);
    const Lanes3<V> move = field.ofCentres(pair.a);
    const V along = hn::Div(Dot(apart, move), Dot(move, move));
    CertifyTrianglesAlong(d, AddScaled(apart, hn::Neg(along), move), pair, need, field, lower, answer.shares);
    return answer;
}

}  // namespace HWY_NAMESPACE
}  // namespace clearway
HWY_AFTER_NAMESPACE();

#endif
