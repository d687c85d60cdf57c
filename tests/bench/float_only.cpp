#include "bench/float_only.h"

#include <cmath>
#include <vector>

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
    TrianglesAt triangles{0, 0, kNoFeature};
};

/// The leaves of the last query's nearest pair, or null.
struct FloatWarmStart {
    const Leaf* part = nullptr;
    const Leaf* environment = nullptr;
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
    FloatPair nearest_{false, 0, hwy::HighestValue<float>(), 0, {0, 0, kNoFeature}};
    float leastLower_ = hwy::HighestValue<float>();
};

template <int kWidth>
HWY_INLINE void LeastWide(const PairQuery& query, const FloatWarmStart& warmStart, Workspace::State& state,
                          FloatPair& found) {
    LeastInFloat visitor;
    if (warmStart.part != nullptr) {
        LeafPairs leaves;
        leaves.meet(query, *warmStart.part, *warmStart.environment, /*volumesBound*/ 0, visitor.dropFrom());
        leaves.visit(visitor);
    }
    Traverse<kWidth>(query, state, visitor);
    found = visitor.found();
}

void LeastInFloat2(const PairQuery& query, const FloatWarmStart& warmStart, Workspace::State& state,
                   FloatPair& found) {
    LeastWide<2>(query, warmStart, state, found);
}

void LeastInFloat8(const PairQuery& query, const FloatWarmStart& warmStart, Workspace::State& state,
                   FloatPair& found) {
    LeastWide<8>(query, warmStart, state, found);
}

}  // namespace HWY_NAMESPACE
}  // namespace clearway
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace clearway {

HWY_EXPORT(LeastInFloat2);
HWY_EXPORT(LeastInFloat8);

namespace testing {
namespace {

std::vector<const Leaf*> leavesOfTriangles(const FlatTree& tree) {
    std::vector<const Leaf*> leaves(tree.triangles.size());
    for (const Leaf& leaf : tree.leaves) {
        for (std::uint32_t k = 0; k < leaf.triangleCount; ++k) leaves[leaf.firstTriangle + k] = &leaf;
    }
    return leaves;
}

}  // namespace

struct FloatOnly::Data {
    Model part, environment;
    std::vector<const Leaf*> partLeaves, environmentLeaves;  ///< the leaf of each triangle
    FloatWarmStart warmStart;
    Workspace workspace;
};

FloatOnly::FloatOnly(const Model& part, const Model& environment)
    : data_(new Data{
          part, environment, leavesOfTriangles(part.tree()), leavesOfTriangles(environment.tree()), {}, {}}) {
}

FloatOnly::~FloatOnly() = default;

void FloatOnly::forgetWarmStart() {
    data_->warmStart = {};
}

Answer FloatOnly::distance(const Pose& X_environmentPart) {
    const FlatTree &part = data_->part.tree(), &environment = data_->environment.tree();
    const PairQuery query = preparePairQuery(part, environment, X_environmentPart);
    Workspace::State& state = data_->workspace.state();
    state.counters = {};
    FloatPair found;
    if (part.nodeWidth == 2) {
        HWY_DYNAMIC_DISPATCH(LeastInFloat2)(query, data_->warmStart, state, found);
    } else {
        HWY_DYNAMIC_DISPATCH(LeastInFloat8)(query, data_->warmStart, state, found);
    }
    data_->warmStart = {data_->partLeaves[found.triangles.part],
                        data_->environmentLeaves[found.triangles.environment]};
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
