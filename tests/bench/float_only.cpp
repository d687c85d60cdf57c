#include "bench/float_only.h"

#include <cmath>
#include <optional>

#include "model/model_data.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "bench/float_only.cpp"
#include "hwy/foreach_target.h"  // must come before highway.h and the kernels

#include "hwy/highway.h"
#include "query/traverse-inl.h"

#ifndef CLEARWAY_BENCH_FLOAT_PAIR
#define CLEARWAY_BENCH_FLOAT_PAIR
namespace clearway {

/// The result, in query units.
struct FloatPair {
    bool touches = false;
    float lower = 0, upper = 0;  ///< bounds of the distance
    float value = 0;
    TrianglesAt triangles;
};

/// The leaves of the last query's nearest pair.
struct FloatWarmStart {
    LeafReference part, environment;
};

}  // namespace clearway
#endif

HWY_BEFORE_NAMESPACE();
namespace clearway {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The visitor: keeps the least upper bound and the least lower bound of all pairs met.
class LeastInFloat {
  public:
    static constexpr bool kPairsMayWait = true;
    float dropFrom() const { return nearest_.upper; }
    bool done() const { return nearest_.touches; }

    template <class D, class V>
    HWY_INLINE TriangleBounds<V> bounds(D d, const TrianglePair<V>& pair, V lower) const {
        return TriangleDistance(d, pair, lower);
    }

    HWY_INLINE void take(float lower, float upper, const TrianglesAt& triangles) {
        if (lower < leastLower_) leastLower_ = lower;
        if (!(lower > 0)) nearest_.touches = true;
        if (upper < nearest_.upper || nearest_.touches) {
            nearest_.value = 0.5f * (lower + upper);
            nearest_.triangles = triangles;
        }
        if (upper < nearest_.upper) nearest_.upper = upper;
    }

    /// Every dropped pair has a bound of at least the least upper bound.
    FloatPair found() const {
        FloatPair pair = nearest_;
        pair.lower = leastLower_ < pair.upper ? leastLower_ : pair.upper;
        if (pair.touches) pair.lower = pair.value = 0;
        return pair;
    }

  private:
    FloatPair nearest_{false, 0, hwy::HighestValue<float>(), 0, {}};
    float leastLower_ = hwy::HighestValue<float>();
};

template <int kWidth, bool kIsExact>
HWY_INLINE void LeastWide(const PairQuery& query, const std::optional<FloatWarmStart>& warmStart,
                          Workspace::State& state, FloatPair& found) {
    LeastInFloat visitor;
    if (warmStart) {
        LeafPairs leaves;
        const Leaf part = query.part->leaf(warmStart->part),
                   environment = query.environment->leaf(warmStart->environment);
        leaves.meet(query, part, environment, /*volumesBound*/ 0, visitor.dropFrom());
        leaves.visit(visitor);
    }
    Traverse<kWidth, kIsExact>(query, state, visitor);
    found = visitor.found();
}

void LeastInFloat2(const PairQuery& query, const std::optional<FloatWarmStart>& warmStart,
                   Workspace::State& state, FloatPair& found) {
    LeastWide<2, true>(query, warmStart, state, found);
}

void LeastInFloat8(const PairQuery& query, const std::optional<FloatWarmStart>& warmStart,
                   Workspace::State& state, FloatPair& found) {
    LeastWide<8, false>(query, warmStart, state, found);
}

void LeastInFloat8Exact(const PairQuery& query, const std::optional<FloatWarmStart>& warmStart,
                        Workspace::State& state, FloatPair& found) {
    LeastWide<8, true>(query, warmStart, state, found);
}

}  // namespace HWY_NAMESPACE
}  // namespace clearway
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace clearway {

HWY_EXPORT(LeastInFloat2);
HWY_EXPORT(LeastInFloat8);
HWY_EXPORT(LeastInFloat8Exact);

namespace testing {
struct FloatOnly::Data {
    Model part, environment;
    bool exactRectangles;
    std::optional<FloatWarmStart> warmStart;
    Workspace workspace;
};

FloatOnly::FloatOnly(const Model& part, const Model& environment, bool exactRectangles)
    : data_(new Data{part, environment, exactRectangles, {}, {}}) {}

FloatOnly::~FloatOnly() = default;

void FloatOnly::forgetWarmStart() {
    data_->warmStart.reset();
}

Answer FloatOnly::distance(const Pose& X_environmentPart) {
    const FlatTree &part = treeOf(data_->part), &environment = treeOf(data_->environment);
    const PairQuery query = preparePairQuery(part, environment, X_environmentPart);
    Workspace::State& state = stateOf(data_->workspace);
    state.counters = {};
    FloatPair found;
    if (part.nodeWidth == 2) {
        HWY_DYNAMIC_DISPATCH(LeastInFloat2)(query, data_->warmStart, state, found);
    } else if (data_->exactRectangles) {
        HWY_DYNAMIC_DISPATCH(LeastInFloat8Exact)(query, data_->warmStart, state, found);
    } else {
        HWY_DYNAMIC_DISPATCH(LeastInFloat8)(query, data_->warmStart, state, found);
    }
    data_->warmStart = FloatWarmStart{found.triangles.part.leaf, found.triangles.environment.leaf};
    Answer answer;
    answer.value = std::ldexp(double(found.value), query.unitExponent);
    answer.lower = std::ldexp(double(found.lower), query.unitExponent);
    answer.upper = std::ldexp(double(found.upper), query.unitExponent);
    answer.counters = state.counters;
    return answer;
}

}  // namespace testing
}  // namespace clearway

#endif  // HWY_ONCE
