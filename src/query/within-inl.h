// The visitor of `isWithin` and of `collides`, which is within 0: stops at the first pair that is near
// enough.
#include "hwy/highway.h"
#include "kernels/tri_tri_distance-inl.h"
#include "kernels/tri_tri_intersect-inl.h"
#include "query/leaf_pairs-inl.h"
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

    bool drops(float bound) const { return bound >= dropFrom_; }
    bool done() const { return found_; }

    HWY_INLINE void leaves(float /*bound*/, const Leaf& part, const Leaf& environment) {
        const LeafPairs pairs(query_, part, environment);
        state_.counters.triangleTests += std::uint64_t(pairs.total());
        const hn::CappedTag<float, kPairLanes> d;
        const auto error = hn::Set(d, pairs.roundingError());
        const auto dropFrom = hn::Set(d, dropFrom_);
        alignas(64) float proved[kPairLanes], upper[kPairLanes];

        const int n = pairs.partCount(), step = pairs.partTrianglesAtOnce();
        for (int first = 0; first < n && !done(); first += step) {
            const int count = pairs.fill(first, first + step < n ? first + step : n, lanes_);
            for (size_t lane = 0; lane < size_t(count) && !done(); lane += hn::Lanes(d)) {
                const TrianglePair<hn::Vec<decltype(d)>> pair(LoadTriangles(d, lanes_.part, lane),
                                                              LoadTriangles(d, lanes_.environment, lane));
                auto lower = CheapSeparation(d, pair);
                const auto unused = hn::Not(hn::FirstN(d, size_t(count) - lane));
                if (hn::AllTrue(d, hn::Or(unused, hn::Ge(hn::Sub(lower, error), dropFrom)))) continue;
                auto most = hn::Set(d, hwy::HighestValue<float>());
                if (d_ > 0) {
                    const auto bounds = TriangleDistance(d, pair, lower);
                    lower = bounds.lower;
                    most = hn::Add(bounds.upper, error);
                } else {
                    lower = hn::Max(lower, EdgeSeparation(d, pair));
                }
                hn::Store(hn::Sub(lower, error), d, proved);
                hn::Store(most, d, upper);
                const int used =
                    int(hn::Lanes(d)) < count - int(lane) ? int(hn::Lanes(d)) : count - int(lane);
                for (int k = 0; k < used && !done(); ++k) {
                    const int at = int(lane) + k;
                    if (drops(proved[k])) continue;
                    take(pairs.partTriangle(first, at), pairs.environmentTriangle(at),
                         double(upper[k]) <= d_);
                }
            }
        }
    }

    HWY_INLINE void resolve(std::uint32_t partTriangle, std::uint32_t environmentTriangle) {
        const ResolvedPair pair = resolvePair(query_, partTriangle, environmentTriangle);
        ++state_.counters.refinedPairs;
        if (pair.contact || pair.lower <= d_) remember(partTriangle, environmentTriangle);
    }

    void write(WithinAnswer& answer) const { answer = {found_, partTriangle_, environmentTriangle_}; }

  private:
    HWY_INLINE void take(std::uint32_t partTriangle, std::uint32_t environmentTriangle, bool surelyWithin) {
        if (surelyWithin) {
            remember(partTriangle, environmentTriangle);
        } else {
            resolve(partTriangle, environmentTriangle);
        }
    }

    void remember(std::uint32_t partTriangle, std::uint32_t environmentTriangle) {
        found_ = true;
        partTriangle_ = partTriangle;
        environmentTriangle_ = environmentTriangle;
    }

    const PairQuery& query_;
    PairLanes lanes_;
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
