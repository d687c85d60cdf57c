// The visitor of `isWithin` and of `collides`, which is within 0: stops at the first pair that is near
// enough.
#include "hwy/highway.h"
#include "kernels/tri_tri_intersect-inl.h"
#include "query/decide.h"
#include "query/traverse-inl.h"

#if defined(CLEARWAY_QUERY_WITHIN_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARWAY_QUERY_WITHIN_INL_H_
#undef CLEARWAY_QUERY_WITHIN_INL_H_
#else
#define CLEARWAY_QUERY_WITHIN_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace clearway {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

class Within {
  public:
    /// d: environment units; infinity is within reach of everything.
    Within(const PairQuery& query, double d, Workspace::State& state)
        : query_(query), exactly_(d), d_(d * query.perMeshUnit), state_(state) {
        const double reach = d_ > kLeastProved ? d_ : kLeastProved;
        dropFrom_ = reach < hwy::HighestValue<float>() ? nextFloatAbove(reach) : hwy::HighestValue<float>();
    }

    float dropFrom() const { return dropFrom_; }
    bool done() const { return found_; }

    /// For contact only a separating direction matters, and no pair is surely touching in float.
    template <class D, class V>
    HWY_INLINE TriangleBounds<V> bounds(D d, const TrianglePair<V>& pair, V lower) const {
        if (d_ > 0) return TriangleDistance(d, pair, lower);
        return {hn::Max(lower, EdgeSeparation(d, pair)), hn::Set(d, hwy::HighestValue<float>()),
                hn::Set(d, float(kNoFeature))};
    }

    HWY_INLINE void take(float /*lower*/, float upper, const TrianglesAt& triangles) {
        if (double(upper) <= d_ && upper > kLeastProved) {
            remember(triangles);
        } else {
            resolve(triangles);
        }
    }

    /// Decides a pair exactly. Returns where it is closest.
    HWY_INLINE std::int32_t resolve(const TrianglesAt& triangles) {
        const PairWithin pair = isPairWithin(query_, triangles, exactly_, state_.counters);
        if (pair.within) remember({triangles.part, triangles.environment, pair.feature});
        return pair.feature;
    }

    void write(WithinAnswer& answer) const { answer = {found_, triangles_}; }

  private:
    void remember(const TrianglesAt& triangles) {
        found_ = true;
        triangles_ = triangles;
    }

    const PairQuery& query_;
    double exactly_;  ///< environment units
    double d_;        ///< query units
    Workspace::State& state_;
    float dropFrom_;
    bool found_ = false;
    TrianglesAt triangles_{0, 0, kNoFeature};
};

template <int kWidth>
HWY_INLINE void WithinWide(const PairQuery& query, double distance, const WarmStart* warmStart,
                           Workspace::State& state, WithinAnswer& answer) {
    Within visitor(query, distance, state);
    // A warm start that is no answer stays for the next query, which then knows where to look at it.
    if (warmStart != nullptr) state.warmStart.triangles.feature = visitor.resolve(warmStart->triangles);
    Traverse<kWidth>(query, state, visitor);
    visitor.write(answer);
}

}  // namespace HWY_NAMESPACE
}  // namespace clearway
HWY_AFTER_NAMESPACE();

#endif
