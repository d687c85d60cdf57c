// Near pairs of triangles of any leaves wait here until they fill a register of the triangle kernel, which costs as much for one
// pair as for a full register. On most scenes the cheap bound leaves 5 of the 16 pairs of two leaves.
#include "hwy/highway.h"
#include "kernels/tri_tri_distance-inl.h"
#include "query/pair_query.h"

#if defined(CLEARWAY_QUERY_WAITING_PAIRS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARWAY_QUERY_WAITING_PAIRS_INL_H_
#undef CLEARWAY_QUERY_WAITING_PAIRS_INL_H_
#else
#define CLEARWAY_QUERY_WAITING_PAIRS_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace clearway {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The registers of pairs of triangles, one pair per lane.
using PairTag = hn::CappedTag<float, 16>;

/// A register of pairs with what bounds of their distances need.
struct RegisterOfPairs {
    using V = hn::Vec<PairTag>;
    TrianglePair<V> triangles;
    std::uint32_t present;  ///< the lanes that hold a pair, as bits
    V roundingError;        ///< of a gap or distance, query units
    V knownBound;           ///< a proved lower bound of the distance
};

/// Takes a register of pairs through the visitor's kernel and hands the visitor those whose distance may be below dropFrom(), until
/// the visitor is done(). trianglesAt(lane, feature): the pair in a lane. Returns false when the visitor is done. A visitor has
///   kPairsMayWait                   whether it loses little when it gets near pairs later than it might
///   bounds(d, pair, lower)          the TriangleBounds of a register of pairs; lower: known bounds
///   take(lower, upper, triangles)   takes a pair with proved bounds of its distance
template <class Visitor, class TrianglesAtLane>
HWY_INLINE bool TakeNear(const RegisterOfPairs& pairs, Visitor& visitor, const TrianglesAtLane& trianglesAt) {
    const PairTag d;
    // A bound that is NaN drops nothing.
    const auto near = [&](RegisterOfPairs::V lower) HWY_ATTR {
        return ~MaskBits(d, hn::Ge(hn::Sub(lower, pairs.roundingError), hn::Set(d, visitor.dropFrom())));
    };
    const auto apart = FaceSeparation(d, pairs.triangles);
    std::uint32_t left = pairs.present & near(apart);
    if (left == 0) return true;
    const auto bounds = visitor.bounds(d, pairs.triangles, apart);
    left &= near(bounds.lower);
    constexpr int kLanes = int(hn::MaxLanes(PairTag()));
    alignas(64) float lowers[kLanes], uppers[kLanes], features[kLanes];
    hn::Store(bounds.feature, d, features);
    hn::Store(hn::Max(hn::Sub(bounds.lower, pairs.roundingError), pairs.knownBound), d, lowers);
    hn::Store(hn::Add(bounds.upper, pairs.roundingError), d, uppers);
    for (; left != 0 && !visitor.done(); left &= left - 1) {
        const std::uint32_t lane = LowestBit(left);
        visitor.take(lowers[lane], uppers[lane], trianglesAt(lane, std::int32_t(features[lane])));
    }
    return !visitor.done();
}

/// Fewer than a register of pairs, and room for a register more. Whoever adds pairs writes whole registers at `count`; entries
/// beyond the pairs have no meaning, and no value at first: to clear them would cost a short query 2 %.
struct WaitingPairs {
    static constexpr int kLanes = int(hn::MaxLanes(PairTag()));
    static constexpr int kRoom = 2 * kLanes;
    alignas(64) float partCorners[9][kRoom];  ///< x, y, z of the three corners; environment's axes
    alignas(64) float environmentCorners[9][kRoom];
    alignas(64) float roundingErrors[kRoom];
    alignas(64) float knownBounds[kRoom];
    alignas(64) std::int32_t partTriangles[kRoom];  ///< positions in the trees
    alignas(64) std::int32_t environmentTriangles[kRoom];
    int count = 0;
    std::uint64_t kernelPairs = 0;  ///< pairs that came to the visitor's kernel so far
    std::uint64_t kernelLanes = 0;  ///< the lanes of their registers

    bool fillRegister() const { return count >= kLanes; }

    /// Takes the first register of pairs, full or not, as TakeNear does.
    template <class Visitor>
    HWY_NOINLINE bool take(Visitor& visitor) {
        using V = RegisterOfPairs::V;
        const PairTag d;
        Triangles<V> a, b;
        for (int k = 0; k < 3; ++k) {
            const auto corner = [&](const float(&rows)[9][kRoom]) HWY_ATTR {
                return Lanes3<V>{hn::Load(d, rows[3 * k]), hn::Load(d, rows[3 * k + 1]),
                                 hn::Load(d, rows[3 * k + 2])};
            };
            a.corner[k] = corner(partCorners);
            b.corner[k] = corner(environmentCorners);
        }
        const int taken = count < kLanes ? count : kLanes;
        kernelPairs += std::uint64_t(taken);
        kernelLanes += std::uint64_t(kLanes);
        const RegisterOfPairs pairs = {TrianglePair<V>(a, b), (1u << taken) - 1, hn::Load(d, roundingErrors),
                                       hn::Load(d, knownBounds)};
        const bool goesOn =
            TakeNear(pairs, visitor, [&](std::uint32_t lane, std::int32_t feature) -> TrianglesAt {
                return {std::uint32_t(partTriangles[lane]), std::uint32_t(environmentTriangles[lane]),
                        feature};
            });
        count -= taken;
        if (count > 0) moveDown();
        return goesOn;
    }

  private:
    /// Moves the second register of pairs to the place of the first.
    HWY_INLINE void moveDown() {
        const PairTag d;
        const hn::RebindToSigned<PairTag> di;
        for (auto& rows : {&partCorners, &environmentCorners}) {
            for (float(&row)[kRoom] : *rows) hn::Store(hn::Load(d, row + kLanes), d, row);
        }
        for (float* row : {roundingErrors, knownBounds}) hn::Store(hn::Load(d, row + kLanes), d, row);
        for (std::int32_t* row : {partTriangles, environmentTriangles}) {
            hn::Store(hn::Load(di, row + kLanes), di, row);
        }
    }
};

}  // namespace HWY_NAMESPACE
}  // namespace clearway
HWY_AFTER_NAMESPACE();

#endif
