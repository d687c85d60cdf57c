// The only dispatch: each query's whole traversal is compiled once per instruction set and node width.
#include "query/queries.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "query/queries.cpp"
#include "hwy/foreach_target.h"  // must come before highway.h and the kernels

#include "hwy/highway.h"
#include "query/closest-inl.h"
#include "query/within-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearway {
namespace HWY_NAMESPACE {

void Closest2(const PairQuery& query, const ClosestRequest& request, const WarmStart* warmStart,
              Workspace::State& state, ClosestAnswer& answer) {
    ClosestWide<2>(query, request, warmStart, state, answer);
}

void Closest8(const PairQuery& query, const ClosestRequest& request, const WarmStart* warmStart,
              Workspace::State& state, ClosestAnswer& answer) {
    ClosestWide<8>(query, request, warmStart, state, answer);
}

void Within2(const PairQuery& query, double distance, const WarmStart* warmStart, Workspace::State& state,
             WithinAnswer& answer) {
    WithinWide<2>(query, distance, warmStart, state, answer);
}

void Within8(const PairQuery& query, double distance, const WarmStart* warmStart, Workspace::State& state,
             WithinAnswer& answer) {
    WithinWide<8>(query, distance, warmStart, state, answer);
}

}  // namespace HWY_NAMESPACE
}  // namespace clearway
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace clearway {

HWY_EXPORT(Closest2);
HWY_EXPORT(Closest8);
HWY_EXPORT(Within2);
HWY_EXPORT(Within8);

ClosestAnswer closestPair(const PairQuery& query, const ClosestRequest& request, const WarmStart* warmStart,
                          Workspace::State& state) {
    ClosestAnswer answer;
    if (query.part->nodeWidth == 2) {
        HWY_DYNAMIC_DISPATCH(Closest2)(query, request, warmStart, state, answer);
    } else {
        HWY_DYNAMIC_DISPATCH(Closest8)(query, request, warmStart, state, answer);
    }
    return answer;
}

WithinAnswer anyPairWithin(const PairQuery& query, double distance, const WarmStart* warmStart,
                           Workspace::State& state) {
    WithinAnswer answer;
    if (query.part->nodeWidth == 2) {
        HWY_DYNAMIC_DISPATCH(Within2)(query, distance, warmStart, state, answer);
    } else {
        HWY_DYNAMIC_DISPATCH(Within8)(query, distance, warmStart, state, answer);
    }
    return answer;
}

void sortByLower(Pile<Candidate>& candidates) {
    std::sort(candidates.begin(), candidates.end(),
              [](const Candidate& a, const Candidate& b) { return a.lower < b.lower; });
}

}  // namespace clearway

#endif  // HWY_ONCE
