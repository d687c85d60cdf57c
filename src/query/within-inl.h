// The visitor of `isWithin` and of `collides`, which is within 0: stops at the first pair that is near
// enough.
#include "hwy/highway.h"
#include "kernels/tri_tri_intersect-inl.h"
#include "query/refine.h"
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
    /// d: query units; infinity is within reach of everything.
    Within(const PairQuery& query, double d, Workspace::State& state) : query_(query), d_(d), state_(state) {
        const double reach = d > kAlwaysResolved ? d : kAlwaysResolved;
        dropFrom_ = reach < hwy::HighestValue<float>() ? nextFloatAbove(reach) : hwy::HighestValue<float>();
    }

    float dropFrom() const { return dropFrom_; }
    bool done() const { return found_; }

    /// For contact only a separating direction matters, and no pair is surely touching in float.
    template <class D, class V>
    HWY_INLINE TriangleBounds<V> bounds(D d, const TrianglePair<V>& pair, V lower) const {
        if (d_ > 0) return TriangleDistance(d, pair, lower);
        return {hn::Max(lower, EdgeSeparation(d, pair)), hn::Set(d, hwy::HighestValue<float>())};
    }

    HWY_INLINE void take(float /*lower*/, float upper, std::uint32_t partTriangle,
                         std::uint32_t environmentTriangle) {
        if (double(upper) <= d_) {
            remember(partTriangle, environmentTriangle);
        } else {
            resolve(partTriangle, environmentTriangle);
        }
    }

    HWY_INLINE void resolve(std::uint32_t partTriangle, std::uint32_t environmentTriangle) {
        const ResolvedPair pair = resolvePair(query_, partTriangle, environmentTriangle);
        ++state_.counters.refinedPairs;
        if (pair.contact || pair.lower <= d_) remember(partTriangle, environmentTriangle);
    }

    void write(WithinAnswer& answer) const { answer = {found_, partTriangle_, environmentTriangle_}; }

  private:
    void remember(std::uint32_t partTriangle, std::uint32_t environmentTriangle) {
        found_ = true;
        partTriangle_ = partTriangle;
        environmentTriangle_ = environmentTriangle;
    }

    const PairQuery& query_;
    double d_;
    Workspace::State& state_;
    float dropFrom_;
    bool found_ = false;
    std::uint32_t partTriangle_ = 0;
    std::uint32_t environmentTriangle_ = 0;
};

template <int kWidth>
HWY_INLINE void WithinWide(const PairQuery& query, double distance, const WarmStart* warmStart,
                           Workspace::State& state, WithinAnswer& answer) {
    Within visitor(query, distance, state);
    if (warmStart != nullptr) visitor.resolve(warmStart->partTriangle, warmStart->environmentTriangle);
    Traverse<kWidth>(query, state, visitor);
    visitor.write(answer);
}

}  // namespace HWY_NAMESPACE
}  // namespace clearway
HWY_AFTER_NAMESPACE();

#endif
