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
        const float error = pairs.roundingError();
        const hn::CappedTag<float, kPairLanes> d;
        PairLanes lanes;
        alignas(64) float lower[kPairLanes], upper[kPairLanes];

        for (int first = 0; first < pairs.total() && !done(); first += kPairLanes) {
            const int count = pairs.fill(first, lanes);
            for (size_t lane = 0; lane < size_t(count); lane += hn::Lanes(d)) {
                const auto bounds = TriangleDistance(d, LoadTriangles(d, lanes.part, lane),
                                                     LoadTriangles(d, lanes.environment, lane));
                hn::Store(bounds.lower, d, lower + lane);
                hn::Store(bounds.upper, d, upper + lane);
            }
            for (int lane = 0; lane < count && !done(); ++lane) {
                const std::uint32_t a = pairs.partTriangle(first + lane),
                                    b = pairs.environmentTriangle(first + lane);
                const float proved = lower[lane] - error;
                if (!(proved > kAlwaysResolved)) {
                    resolve(a, b);  // may touch, pierce or be ill-conditioned: float says nothing about it
                } else if (!drops(proved)) {
                    // The volumes may have proved more than the triangles' slabs.
                    state_.candidates.push({proved > bound ? proved : bound, a, b});
                    const double least = double(upper[lane]) + double(error);
                    if (least < leastUpper_) {
                        nearest_ = state_.candidates[state_.candidates.size() - 1];
                        shrink(least);
                    }
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
