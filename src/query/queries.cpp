// The visitors of the two queries and the only dispatch: each query's whole traversal is compiled once per
// instruction set, and in each once per node width.
#include "query/queries.h"

#include <algorithm>
#include <tuple>
#include <utility>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "query/queries.cpp"
#include "hwy/foreach_target.h"  // must come before highway.h and the kernels

#include "hwy/highway.h"
#include "query/bound_pairs-inl.h"
#include "query/decide.h"
#include "query/traverse-inl.h"
#include "query/witnesses-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearway {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Pairs whose distances differ by less than this, in u64 M, count as equally close: an answer's interval may
/// be kWidthRoundoffs wide, and at such distances bounds in double are rounded by up to kPairPlaceRoundoffs.
constexpr double kTieRoundoffs = kWidthRoundoffs - kPairPlaceRoundoffs;

/// The visitor of closestPair: shrinks an upper bound in float, keeps the pairs that may be the closest, and
/// resolves them in double or, where double leaves too much open, beyond.
class Closest {
  public:
    Closest(const PairQuery& query, const ClosestRequest& request, Workspace::State& state)
        : query_(query), request_(request), state_(state) {
        state.candidates.clear();
        lowerDropFrom(request.cap);
    }

    static constexpr bool kPairsMayWait = true;
    float dropFrom() const { return dropFrom_; }
    bool done() const { return answer_.contact == Verdict::yes; }

    template <class D, class V>
    HWY_INLINE TriangleBounds<V> bounds(D d, const TrianglePair<V>& pair, V lower) const {
        return TriangleDistance(d, pair, lower);
    }

    /// Takes a pair of triangles with a proved lower and a proved upper bound, both from float.
    HWY_INLINE void take(float lower, float upper, const TrianglesAt& triangles) {
        if (!(lower > kLeastProved)) {
            resolve(triangles);  // such a pair may touch, pierce or be ill-conditioned
        } else if (!drops(lower)) {
            const Candidate pair{lower, triangles};
            state_.candidates.push(pair);
            if (double(upper) < leastUpper_) {
                nearest_ = pair;
                shrink(upper);
            }
        }
    }

    /// Resolves a pair, and remembers the pair if it is the closest so far.
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

    /// Resolves the remaining candidates, the least bound first, and writes the answer.
    void finish(ClosestAnswer& out) {
        Pile<Candidate>& candidates = state_.candidates;
        if (!done()) {
            // The pair that set the upper bound comes first, because a wide tolerance would drop it by its
            // own lower bound.
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
        // Every pair that was not resolved has a lower bound of dropFrom_ or more.
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

    /// Bounds several pairs at once. A pair that ties with the answer up to rounding only lowers the answer's
    /// lower bound; a pair that may be closer, or has no good bound, is resolved.
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

    /// Takes a smaller upper bound of the distance. Dropping pairs from a bound b on leaves the interval [b,
    /// upper], which may be as wide as the request allows.
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
    double leastUpper_ = hwy::HighestValue<double>();  ///< least upper bound of the distance so far
    double leastLower_ = hwy::HighestValue<double>();  ///< least lower bound of the resolved pairs
    Candidate nearest_{};                              ///< set leastUpper_, unless a resolved pair set it
    bool found_ = false;
    ResolvedPair answer_;
    TrianglesAt answerTriangles_;
};

ClosestAnswer FindClosest(const PairQuery& query, const ClosestRequest& request, Workspace::State& state) {
    ClosestAnswer answer;
    const int first = NearestWitness(query, state.witnesses);
    // The visitor is a local variable of the whole traversal, so that it can stay in registers.
    withNodeWidth(query.part->nodeWidth, [&](auto width) HWY_ATTR {
        Closest visitor(query, request, state);
        if (first >= 0) {
            visitor.resolve(state.witnesses.triangles[first]);
        } else if (state.witnesses.isLastKnown) {
            visitor.resolve(state.witnesses.last);
        }
        Traverse<width>(query, state, visitor);
        visitor.finish(answer);
    });
    return answer;
}

/// The visitor of anyPairWithin: stops at the first pair that is near enough.
class Within {
  public:
    /// d: environment units; with infinity every pair is within.
    Within(const PairQuery& query, double d, Workspace::State& state)
        : query_(query), exactly_(d), d_(d * query.perMeshUnit), state_(state) {
        const double reach = d_ > kLeastProved ? d_ : kLeastProved;
        dropFrom_ = reach < hwy::HighestValue<float>() ? nextFloatAbove(reach) : hwy::HighestValue<float>();
    }

    static constexpr bool kPairsMayWait = false;  // the first pair that is within ends the query
    float dropFrom() const { return dropFrom_; }
    bool done() const { return found_; }

    /// Contact only needs a separating direction, and float never proves contact.
    template <class D, class V>
    HWY_INLINE TriangleBounds<V> bounds(D d, const TrianglePair<V>& pair, V lower) const {
        if (d_ > 0) return TriangleDistance(d, pair, lower);
        return {hn::Max(lower, EdgeSeparation(d, pair)), hn::Set(d, hwy::HighestValue<float>()),
                hn::Set(d, float(kNoFeature)), pair.edgeA[0]};
    }

    HWY_INLINE void take(float /*lower*/, float upper, const TrianglesAt& triangles) {
        if (double(upper) <= d_ && upper > kLeastProved) {
            remember(triangles);
        } else {
            resolve(triangles);
        }
    }

    /// Decides a pair exactly. Returns the features on which the pair is closest, a guess.
    HWY_INLINE std::int32_t resolve(const TrianglesAt& triangles) {
        const PairWithin pair = isPairWithin(query_, triangles, exactly_, state_.counters);
        if (pair.within) remember({triangles.part, triangles.environment, pair.feature});
        return pair.feature;
    }

    WithinAnswer answer() const { return {found_, triangles_}; }

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
    TrianglesAt triangles_;
};

WithinAnswer FindWithin(const PairQuery& query, double distance, Workspace::State& state) {
    WithinAnswer answer;
    withNodeWidth(query.part->nodeWidth, [&](auto width) HWY_ATTR {
        Within visitor(query, distance, state);
        // A pair that does not answer this query stays for the next one, which then knows its closest features.
        TrianglesAt& last = state.witnesses.last;
        if (state.witnesses.isLastKnown) last.feature = visitor.resolve(last);
        Traverse<width>(query, state, visitor);
        answer = visitor.answer();
    });
    return answer;
}

/// The visitor of pairsWithin: keeps all pairs that may be near enough.
class Near {
  public:
    Near(double band, Workspace::State& state) : state_(state) {
        const double reach = band > kLeastProved ? band : kLeastProved;
        dropFrom_ = reach < hwy::HighestValue<float>() ? nextFloatAbove(reach) : hwy::HighestValue<float>();
        state.candidates.clear();
    }

    static constexpr bool kPairsMayWait = true;
    float dropFrom() const { return dropFrom_; }
    bool done() const { return false; }
    bool isThinned() const { return isThinned_; }

    template <class D, class V>
    HWY_INLINE TriangleBounds<V> bounds(D d, const TrianglePair<V>& pair, V lower) const {
        return TriangleDistance(d, pair, lower);
    }

    HWY_INLINE void take(float lower, float /*upper*/, const TrianglesAt& triangles) {
        state_.candidates.push({lower, triangles});
        if (state_.candidates.size() < kMostCandidates) return;
        keepNearest(state_.candidates, false);
        isThinned_ = true;
    }

  private:
    Workspace::State& state_;
    float dropFrom_;
    bool isThinned_ = false;
};

bool FindNear(const PairQuery& query, double band, Workspace::State& state) {
    bool isThinned = false;
    withNodeWidth(query.part->nodeWidth, [&](auto width) HWY_ATTR {
        Near visitor(band * query.perMeshUnit, state);
        Traverse<width>(query, state, visitor);
        isThinned = visitor.isThinned();
    });
    return isThinned;
}

}  // namespace HWY_NAMESPACE
}  // namespace clearway
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace clearway {

Workspace::Workspace() : state_(std::make_unique<State>()) {}
Workspace::~Workspace() = default;
Workspace::Workspace(Workspace&&) noexcept = default;
Workspace& Workspace::operator=(Workspace&&) noexcept = default;

void Workspace::forgetWarmStart() {
    const WorkspaceUse use(*state_);
    state_->witnesses.forget();
}

const QueryCounters& Workspace::counters() const {
    return state_->counters;
}

HWY_EXPORT(FindClosest);
HWY_EXPORT(FindWithin);
HWY_EXPORT(FindNear);

ClosestAnswer closestPair(const PairQuery& query, const ClosestRequest& request, Workspace::State& state) {
    settleTarget();
    return HWY_DYNAMIC_DISPATCH(FindClosest)(query, request, state);
}

WithinAnswer anyPairWithin(const PairQuery& query, double distance, Workspace::State& state) {
    settleTarget();
    return HWY_DYNAMIC_DISPATCH(FindWithin)(query, distance, state);
}

bool pairsWithin(const PairQuery& query, double band, Workspace::State& state) {
    settleTarget();
    return HWY_DYNAMIC_DISPATCH(FindNear)(query, band, state);
}

void keepNearest(Pile<Candidate>& candidates, bool isByPairs) {
    const auto leavesOf = [&](const Candidate& pair) {
        return std::pair(pair.triangles.part.leaf, isByPairs ? pair.triangles.environment.leaf : 0);
    };
    const auto orderOf = [&](const Candidate& pair) {
        return std::tuple(leavesOf(pair), pair.lower, pair.triangles.part.number,
                          pair.triangles.environment.leaf, pair.triangles.environment.number);
    };
    std::sort(candidates.begin(), candidates.end(),
              [&](const Candidate& a, const Candidate& b) { return orderOf(a) < orderOf(b); });
    const Candidate* const end =
        std::unique(candidates.begin(), candidates.end(),
                    [&](const Candidate& a, const Candidate& b) { return leavesOf(a) == leavesOf(b); });
    while (candidates.end() != end) candidates.pop();
}

void sortByLower(Pile<Candidate>& candidates) {
    std::sort(candidates.begin(), candidates.end(),
              [](const Candidate& a, const Candidate& b) { return a.lower < b.lower; });
}

}  // namespace clearway

#endif  // HWY_ONCE
