// The visitor of `distance`: shrinks an upper bound in float, keeps the pairs that may be the closest,
// resolves them in double and, where that leaves too much open, beyond.
#include "hwy/highway.h"
#include "query/bound_pairs-inl.h"
#include "query/decide.h"
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

/// Pairs closer to each other than this, in u64 M, count as equally close: an answer's interval may be 32
/// wide, and at such distances bounds are rounded by up to 2.
constexpr double kTieRoundoffs = 30;

class Closest {
  public:
    Closest(const PairQuery& query, const ClosestRequest& request, Workspace::State& state)
        : query_(query), request_(request), state_(state) {
        state.candidates.clear();
        lowerDropFrom(request.cap);
    }

    float dropFrom() const { return dropFrom_; }
    bool done() const { return answer_.contact == Verdict::yes; }

    template <class D, class V>
    HWY_INLINE TriangleBounds<V> bounds(D d, const TrianglePair<V>& pair, V lower) const {
        return TriangleDistance(d, pair, lower);
    }

    /// A pair with a proved lower and a true upper bound, both of float's work.
    HWY_INLINE void take(float lower, float upper, const TrianglesAt& triangles) {
        if (!(lower > kLeastProved)) {
            resolve(triangles);  // may touch, pierce or be ill-conditioned
        } else if (!drops(lower)) {
            const Candidate pair{lower, triangles};
            state_.candidates.push(pair);
            if (double(upper) < leastUpper_) {
                nearest_ = pair;
                shrink(upper);
            }
        }
    }

    /// Resolves a pair and remembers it when it is the closest so far.
    HWY_INLINE void resolve(const TrianglesAt& triangles) {
        const double width =
            request_.absoluteError > query_.defaultWidth ? request_.absoluteError : query_.defaultWidth;
        const ResolvedPair pair =
            settlePair(query_, triangles, {width, request_.relativeError, leastUpper_}, state_.counters);
        if (pair.lower < leastLower_) leastLower_ = pair.lower;
        if (found_ && !(pair.upper < answer_.upper)) return;
        found_ = true;
        answer_ = pair;
        answerTriangles_ = {triangles.part, triangles.environment, pair.feature};
        if (pair.upper < leastUpper_) shrink(pair.upper);
    }

    /// Resolves what is left of the candidates, the least bound first, and writes the answer.
    void finish(ClosestAnswer& out) {
        Pile<Candidate>& candidates = state_.candidates;
        if (!done()) {
            // The pair that set the upper bound comes first: with a wide tolerance its own lower bound would
            // be dropped.
            if (!candidates.empty() && !(answer_.upper <= leastUpper_ && found_)) {
                resolve(nearest_.triangles);
            }
            sortByLower(candidates);
            resolveCandidates(candidates);
        }
        out.pair = answer_;
        out.triangles = answerTriangles_;
        if (done()) {
            out.found = true;
            return;
        }
        // Whatever was not resolved has a bound of dropFrom_ or more.
        out.pair.lower = leastLower_ < double(dropFrom_) ? leastLower_ : double(dropFrom_);
        out.found = found_ && !(answer_.upper > request_.cap && out.pair.lower >= request_.cap);
        if (!out.found && out.pair.lower < request_.cap) out.pair.lower = request_.cap;
    }

  private:
    HWY_NOINLINE void resolveCandidates(Pile<Candidate>& candidates) {
        Candidate together[kPairsTogether];
        const Candidate *next = candidates.begin(), *end = candidates.end();
        while (next != end && !drops(next->lower) && !done()) {
            int count = 0;
            for (; next != end && count < kPairsTogether && !drops(next->lower); ++next) {
                if (!isAnswer(*next)) together[count++] = *next;
            }
            resolveTogether(together, count);
        }
    }

    bool isAnswer(const Candidate& pair) const {
        return found_ && pair.triangles.part == answerTriangles_.part &&
               pair.triangles.environment == answerTriangles_.environment;
    }

    /// Pairs that are as close as the answer, but for rounding, only lower its lower bound; what may be
    /// closer, or is not proved well, is resolved.
    HWY_INLINE void resolveTogether(const Candidate* pairs, int count) {
        alignas(64) double lower[kPairsTogether] = {};
        if (count > 1) {
            BoundPairs(query_, pairs, count, lower);
            state_.counters.refinedPairs += std::uint64_t(count);
        }
        const double tie = kTieRoundoffs * kUnitRoundoffDouble * query_.largestCoordinate;
        for (int k = 0; k < count && !done(); ++k) {
            if (lower[k] >= double(dropFrom_)) continue;
            if (found_ && lower[k] > 0 && lower[k] >= answer_.upper - tie) {
                if (lower[k] < leastLower_) leastLower_ = lower[k];
            } else {
                resolve(pairs[k].triangles);
            }
        }
    }

    bool drops(float bound) const { return bound >= dropFrom_; }

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
        if (from < kLeastProved) from = kLeastProved;
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
    TrianglesAt answerTriangles_{0, 0, kNoFeature};
};

template <int kWidth>
HWY_INLINE void ClosestWide(const PairQuery& query, const ClosestRequest& request, const WarmStart* warmStart,
                            Workspace::State& state, ClosestAnswer& answer) {
    Closest visitor(query, request, state);
    if (warmStart != nullptr) visitor.resolve(warmStart->triangles);
    Traverse<kWidth>(query, state, visitor);
    visitor.finish(answer);
}

}  // namespace HWY_NAMESPACE
}  // namespace clearway
HWY_AFTER_NAMESPACE();

#endif
