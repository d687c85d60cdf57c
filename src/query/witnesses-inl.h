// Finds the witness that is nearest at a pose.
#include "hwy/highway.h"
#include "kernels/vector3-inl.h"
#include "query/witnesses.h"

#if defined(CLEARWAY_QUERY_WITNESSES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARWAY_QUERY_WITNESSES_INL_H_
#undef CLEARWAY_QUERY_WITNESSES_INL_H_
#else
#define CLEARWAY_QUERY_WITNESSES_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace clearway {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The place of the witness whose two points are nearest to each other at the query's pose, or -1 without witnesses. Rounding
/// may choose another one: a query may begin with any pair.
HWY_INLINE int NearestWitness(const PairQuery& query, const Witnesses& witnesses) {
    if (witnesses.count <= 1) return witnesses.count - 1;
    const hn::CappedTag<float, 16> d;
    using V = hn::Vec<decltype(d)>;
    const Carry& carry = query.partToEnvironment;
    V least = hn::Set(d, hwy::HighestValue<float>()), at = hn::Set(d, -1.0f);
    for (int first = 0; first < witnesses.count; first += int(hn::Lanes(d))) {
        const auto part = [&](int row) HWY_ATTR { return hn::Load(d, witnesses.onPart[row] + first); };
        const V x = part(0), y = part(1), z = part(2);
        const auto difference = [&](int row) HWY_ATTR {
            auto sum = hn::Mul(hn::Set(d, carry.columns[2][row]), z);
            sum = hn::MulAdd(hn::Set(d, carry.columns[1][row]), y, sum);
            sum = hn::MulAdd(hn::Set(d, carry.columns[0][row]), x, sum);
            sum = hn::MulAdd(sum, hn::Set(d, carry.ratio), hn::Set(d, carry.translation[row]));
            return hn::Sub(sum, hn::Load(d, witnesses.onEnvironment[row] + first));
        };
        const Lanes3<V> v = {difference(0), difference(1), difference(2)};
        const V squared = Dot(v, v);
        const auto nearer = hn::And(hn::Lt(squared, least), hn::FirstN(d, size_t(witnesses.count - first)));
        least = hn::IfThenElse(nearer, squared, least);
        at = hn::IfThenElse(nearer, hn::Set(d, float(first)), at);
    }
    const auto nearest = hn::Eq(least, hn::MinOfLanes(d, least));
    const auto lane = hn::FindFirstTrue(d, nearest);
    if (lane < 0) return -1;  // the pose or all points are NaN
    alignas(64) float places[16];
    hn::Store(at, d, places);
    return places[lane] < 0 ? -1 : int(places[lane]) + int(lane);
}

}  // namespace HWY_NAMESPACE
}  // namespace clearway
HWY_AFTER_NAMESPACE();

#endif
