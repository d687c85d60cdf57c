// Pairs by clearway's own kernels (src/kernels), compiled for every instruction set: first the walk that
// drops most pairs of leaves, then the kernels of a pair. Pairs that float does not prove apart stay open;
// double decides them, as in a query of clearway.
#include <algorithm>

#include "bench/pair_kernels.h"
#include "clearway/targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "bench/clearway_pairs.cpp"
#include "hwy/foreach_target.h"  // must come before highway.h and the kernels

#include "hwy/highway.h"
#include "kernels/tri_tri_distance-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearway {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using PairsTag = hn::CappedTag<float, 16>;  // as for the leaves of trees
static_assert(hn::MaxLanes(PairsTag()) <= testing::kPadding);

HWY_INLINE Triangles<hn::Vec<PairsTag>> SpreadOne(const float* x) {
    const PairsTag d;
    Triangles<hn::Vec<PairsTag>> t;
    for (int k = 0; k < 3; ++k) {
        t.corner[k] = {hn::Set(d, x[3 * k]), hn::Set(d, x[3 * k + 1]), hn::Set(d, x[3 * k + 2])};
    }
    return t;
}

HWY_INLINE Triangles<hn::Vec<PairsTag>> LoadSome(const testing::PairsOfCall& pairs, int first) {
    const PairsTag d;
    Triangles<hn::Vec<PairsTag>> t;
    const auto row = [&](int k) HWY_ATTR { return hn::LoadU(d, pairs.rows + k * pairs.stride + first); };
    for (int k = 0; k < 3; ++k) t.corner[k] = {row(3 * k), row(3 * k + 1), row(3 * k + 2)};
    return t;
}

/// Which pairs are proved to be apart.
HWY_INLINE hn::Mask<PairsTag> Apart(const Triangles<hn::Vec<PairsTag>>& a,
                                    const Triangles<hn::Vec<PairsTag>>& b, float slack) {
    const PairsTag d;
    const auto between =
        (b.corner[0] + b.corner[1] + b.corner[2]) - (a.corner[0] + a.corner[1] + a.corner[2]);
    const auto third = hn::Set(d, 1.0f / 3);
    const Lanes3<hn::Vec<PairsTag>> start = {hn::Mul(between.x, third), hn::Mul(between.y, third),
                                             hn::Mul(between.z, third)};
    constexpr int kWalkSteps = 1;  // as for the leaves of trees
    auto apart = WalkProvesApart<kWalkSteps>(d, a, b, start, hn::Set(d, NeedSquared(slack)));
    if (hn::AllTrue(d, apart)) return apart;
    const TrianglePair<hn::Vec<PairsTag>> pair(a, b);
    const auto need = hn::Set(d, slack);
    apart = hn::Or(apart, hn::Gt(FaceSeparation(d, pair), need));
    if (hn::AllTrue(d, apart)) return apart;
    return hn::Or(apart, hn::Gt(EdgeSeparation(d, pair), need));
}

void CollidesInFloat(const testing::PairsOfCall& pairs, const testing::PairAnswers& answers) {
    const PairsTag d;
    const hn::RebindToSigned<PairsTag> di;
    const auto a = SpreadOne(pairs.aInFloat);
    for (int i = 0; i < pairs.count; i += int(hn::MaxLanes(d))) {
        const auto apart = hn::RebindMask(di, Apart(a, LoadSome(pairs, i), pairs.slack));
        hn::StoreU(hn::IfThenZeroElse(apart, hn::Set(di, 1)), di, answers.touches + i);
    }
}

void DistanceInFloat(const testing::PairsOfCall& pairs, const testing::PairAnswers& answers) {
    const PairsTag d;
    const auto a = SpreadOne(pairs.aInFloat);
    for (int i = 0; i < pairs.count; i += int(hn::MaxLanes(d))) {
        const TrianglePair<hn::Vec<PairsTag>> pair(a, LoadSome(pairs, i));
        const auto bounds = TriangleDistance(d, pair, FaceSeparation(d, pair));
        const auto apart = hn::Gt(bounds.lower, hn::Set(d, pairs.slack));
        hn::StoreU(hn::IfThenElseZero(apart, bounds.upper), d, answers.distances + i);
    }
}

void CollidesWithDouble(const testing::PairsOfCall& pairs, const testing::PairAnswers& answers) {
    CollidesInFloat(pairs, answers);
    testing::collidesOfOpenPairs(pairs, answers);
}

void DistanceWithDouble(const testing::PairsOfCall& pairs, const testing::PairAnswers& answers) {
    DistanceInFloat(pairs, answers);
    testing::distanceOfOpenPairs(pairs, answers);
}

}  // namespace HWY_NAMESPACE
}  // namespace clearway
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace clearway {

HWY_EXPORT(CollidesInFloat);
HWY_EXPORT(DistanceInFloat);
HWY_EXPORT(CollidesWithDouble);
HWY_EXPORT(DistanceWithDouble);

namespace testing {

std::vector<PairContender> clearwayContenders() {
    std::vector<PairContender> kernels, withDouble;
    const std::vector<std::string> available = availableTargets();
    for (const auto& [target, name] : {std::pair("sse4", "SSE4"), {"avx2", "AVX2"}, {"avx3", "AVX-512"}}) {
        PairContender kernel = {"clearway", "clearway", name, "not on this processor"};
        kernel.leavesOpen = true;
        PairContender both = {"clearway with double", "clearway", name, kernel.missing};
        if (std::find(available.begin(), available.end(), target) != available.end()) {
            useTarget(target);
            hwy::GetChosenTarget().Update(hwy::SupportedTargets());
            kernel.missing = both.missing = "";
            kernel.collides = &HWY_DYNAMIC_DISPATCH(CollidesInFloat);
            kernel.distance = &HWY_DYNAMIC_DISPATCH(DistanceInFloat);
            both.collides = &HWY_DYNAMIC_DISPATCH(CollidesWithDouble);
            both.distance = &HWY_DYNAMIC_DISPATCH(DistanceWithDouble);
        }
        kernels.push_back(kernel);
        withDouble.push_back(both);
    }
    useTarget("best");
    kernels.insert(kernels.end(), withDouble.begin(), withDouble.end());
    return kernels;
}

}  // namespace testing
}  // namespace clearway

#endif  // HWY_ONCE
