// The visitor of `distance`: shrinks an upper bound in float, keeps the pairs that may be the closest,
// resolves them in double.
#include "hwy/highway.h"
#include "kernels/tri_tri_distance-inl.h"
#include "query/leaf_pairs-inl.h"
#include "query/refine.h"
#include "query/traverse-inl.h"

#if defined(CLEARWAY_QUERY_CLOSEST_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARWAY_QUERY_CLOSEST_INL_H_
#undef CLEARWAY_QUERY_CLOSEST_INL_H_
#else
#define CLEARWAY_QUERY_CLOSEST_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace clearway {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

class Closest {
  public:
    Closest(const PairQuery& query, const ClosestRequest& request, Workspace::State& state)
        : query_(query), request_(request), state_(state) {
        state.candidates.clear();
        lowerDropFrom(request.cap);
    }

    bool drops(float bound) const { return bound >= dropFrom_; }
    bool done() const { return answer_.contact; }

    HWY_INLINE void leaves(float bound, const Leaf& part, const Leaf& environment) {
        const LeafPairs pairs(query_, part, environment);
        state_.counters.triangleTests += std::uint64_t(pairs.total());
        const hn::CappedTag<float, kPairLanes> d;
        const auto error = hn::Set(d, pairs.roundingError());
        alignas(64) float proved[kPairLanes], upper[kPairLanes];

        const int n = pairs.partCount(), step = pairs.partTrianglesAtOnce();
        for (int first = 0; first < n && !done(); first += step) {
            const int count = pairs.fill(first, first + step < n ? first + step : n, lanes_);
            for (size_t lane = 0; lane < size_t(count) && !done(); lane += hn::Lanes(d)) {
                const TrianglePair<hn::Vec<decltype(d)>> pair(LoadTriangles(d, lanes_.part, lane),
                                                              LoadTriangles(d, lanes_.environment, lane));
                const auto cheap = CheapSeparation(d, pair);
                const auto dropFrom = hn::Set(d, dropFrom_);
                const auto unused = hn::Not(hn::FirstN(d, size_t(count) - lane));
                if (hn::AllTrue(d, hn::Or(unused, hn::Ge(hn::Sub(cheap, error), dropFrom)))) continue;
                const auto bounds = TriangleDistance(d, pair, cheap);
                hn::Store(hn::Sub(bounds.lower, error), d, proved);
                hn::Store(hn::Add(bounds.upper, error), d, upper);
                const int used =
                    int(hn::Lanes(d)) < count - int(lane) ? int(hn::Lanes(d)) : count - int(lane);
                for (int k = 0; k < used && !done(); ++k) {
                    const int at = int(lane) + k;
                    take({proved[k], pairs.partTriangle(first, at), pairs.environmentTriangle(at)}, bound,
                         upper[k]);
                }
            }
        }
    }

    /// Resolves a pair in double and remembers it when it is the closest so far.
    HWY_INLINE void resolve(std::uint32_t partTriangle, std::uint32_t environmentTriangle) {
        const ResolvedPair pair = resolvePair(query_, partTriangle, environmentTriangle);
        ++state_.counters.refinedPairs;
        if (pair.lower < leastLower_) leastLower_ = pair.lower;
        if (found_ && !(pair.upper < answer_.upper)) return;
        found_ = true;
        answer_ = pair;
        answerPart_ = partTriangle;
        answerEnvironment_ = environmentTriangle;
        if (pair.upper < leastUpper_) shrink(pair.upper);
    }

    /// Resolves what is left of the candidates, the least bound first, and writes the answer.
    void finish(ClosestAnswer& out) {
        Pile<Candidate>& candidates = state_.candidates;
        if (!done()) {
            // The pair that set the upper bound comes first: with a wide tolerance its own lower bound would
            // be dropped.
            if (!candidates.empty() && !(answer_.upper <= leastUpper_ && found_)) {
                resolve(nearest_.partTriangle, nearest_.environmentTriangle);
            }
            sortByLower(candidates);
            for (const Candidate& candidate : candidates) {
                if (done() || drops(candidate.lower)) break;
                resolve(candidate.partTriangle, candidate.environmentTriangle);
            }
        }
        out.pair = answer_;
        out.partTriangle = answerPart_;
        out.environmentTriangle = answerEnvironment_;
        if (answer_.contact) {
            out.found = true;
            return;
        }
        // Whatever was not resolved has a bound of dropFrom_ or more.
        out.pair.lower = leastLower_ < double(dropFrom_) ? leastLower_ : double(dropFrom_);
        out.found = found_ && !(answer_.upper > request_.cap && out.pair.lower >= request_.cap);
        if (!out.found && out.pair.lower < request_.cap) out.pair.lower = request_.cap;
    }

  private:
    /// A pair with its proved lower bound, its volumes' bound and a true upper bound, all of float's work.
    HWY_INLINE void take(Candidate pair, float volumesBound, float upper) {
        if (!(pair.lower > kAlwaysResolved)) {
            resolve(pair.partTriangle, pair.environmentTriangle);  // may touch, pierce or be ill-conditioned
        } else if (!drops(pair.lower)) {
            if (volumesBound > pair.lower) pair.lower = volumesBound;
            state_.candidates.push(pair);
            if (double(upper) < leastUpper_) {
                nearest_ = pair;
                shrink(upper);
            }
        }
    }

    /// Takes a smaller true upper bound of the distance. Dropping at bound b leaves an interval [b, upper],
    /// which may be as wide as the request says.
    void shrink(double upper) {
        leastUpper_ = upper;
        double from = upper;
        if (request_.absoluteError > 0) from = upper - request_.absoluteError;
        if (request_.relativeError > 0) {
            const double relative = upper / (1 + request_.relativeError);
            from = request_.absoluteError > 0 && from < relative ? from : relative;
        }
        lowerDropFrom(from);
    }

    void lowerDropFrom(double from) {
        if (from < kAlwaysResolved) from = kAlwaysResolved;
        if (from < hwy::HighestValue<float>()) {
            const float limit = nextFloatAbove(from);
            if (limit < dropFrom_) dropFrom_ = limit;
        }
    }

    const PairQuery& query_;
    PairLanes lanes_;
    const ClosestRequest& request_;
    Workspace::State& state_;
    float dropFrom_ = hwy::HighestValue<float>();
    double leastUpper_ = hwy::HighestValue<double>();  ///< of the distance, as far as known
    double leastLower_ = hwy::HighestValue<double>();  ///< of the pairs resolved
    Candidate nearest_{};                              ///< set leastUpper_, unless a resolved pair did
    bool found_ = false;
    ResolvedPair answer_;
    std::uint32_t answerPart_ = 0;
    std::uint32_t answerEnvironment_ = 0;
};

template <int kWidth>
HWY_INLINE void ClosestWide(const PairQuery& query, const ClosestRequest& request, const WarmStart* warmStart,
                            Workspace::State& state, ClosestAnswer& answer) {
    Closest visitor(query, request, state);
    if (warmStart != nullptr) visitor.resolve(warmStart->partTriangle, warmStart->environmentTriangle);
    Traverse<kWidth>(query, state, visitor);
    visitor.finish(answer);
}

}  // namespace HWY_NAMESPACE
}  // namespace clearway
HWY_AFTER_NAMESPACE();

#endif
