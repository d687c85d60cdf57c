// The traversal of a sweep: depth first through pairs of volumes and intervals of time. A pair is looked at in the middle of
// its interval, where its gap certifies a share of the interval's halves; what that leaves open is kept for later, as shorter
// intervals of the pair or of the children of one of its volumes. A pair of leaves is divided in time only.
#include <cmath>
#include <limits>

#include "hwy/highway.h"
#include "kernels/moving_rss_bound-inl.h"
#include "kernels/moving_triangles-inl.h"
#include "query/decide.h"
#include "query/motion_pieces.h"
#include "query/sweep.h"
#include "query/traverse-inl.h"

#if defined(CLEARWAY_QUERY_SWEEP_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARWAY_QUERY_SWEEP_INL_H_
#undef CLEARWAY_QUERY_SWEEP_INL_H_
#else
#define CLEARWAY_QUERY_SWEEP_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace clearway {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// A pair that moves by more than this times its larger volume is halved in time unlooked at. Without this rule, long
/// motions open hundreds of times the volumes; between 0.5 and 2 the visits hardly change.
constexpr float kLongestMove = 1;

/// From this share on, a certified part of an interval is cut off before the pair's volumes are opened.
constexpr float kShareToCutOff = 0.5f;

/// How often the whole motion is halved to find where contact does not count, before volumes are opened.
constexpr int kMostHalvesForCounts = 10;

/// A motion that is undecided somewhere is searched for contact in intervals this many times longer than the least one.
constexpr double kCoarser = 64;

/// SweepEntry::moved of a pair that was not looked at; half of it is as much.
constexpr float kUnknownMove = std::numeric_limits<float>::infinity();

/// Steps between two looks at SweepRequest::isStopped.
constexpr int kStepsToStop = 256;

/// Where the float interval of a pair is wider than this share of what the pair has to spare, double resolves the pair: for
/// long triangles float loses more than the gap.
constexpr float kTooWide = 0.25f;

template <int kWidth>
class Sweep {
  public:
    Sweep(const FlatTree& part, const FlatTree& environment, const MotionPieces& motion,
          const SweepRequest& request, Workspace::State& state, SweepAnswer& answer)
        : part_(part),
          environment_(environment),
          request_(request),
          state_(state),
          stack_(state.sweepStack),
          answer_(answer),
          stop_(request.until),
          contactTime_(request.isContactAtEnd ? request.until : std::numeric_limits<double>::infinity()),
          leastUpper_(std::fmin(request.known.clearance, request.cap)),
          leastInterval_(request.leastInterval),
          isReached_(request.known.clearance < request.cap) {
        answer_.nearest = request.known;
        endIfNear();
        if (!state.pieces) state.pieces = std::make_unique<PieceCache>();
        state.pieces->begin(part, environment, motion);
    }

    HWY_INLINE void run() {
        begin();
        while (!stack_.empty() && !isDone_) {
            if (isToStop()) break;
            const SweepEntry entry = stack_.pop();
            const TimeInterval interval{entry.interval};
            if (interval.from() >= stop_ || interval.to() <= request_.from) continue;
            if (request_.goal == SweepGoal::kForward &&
                contactTime_ - interval.from() <= request_.contactTime) {
                stop_ = interval.from();
                continue;
            }
            const double middle = interval.middle();
            if ((middle >= stop_ || middle <= request_.from) && interval.canBeHalved()) {
                push(entry, middle >= stop_ ? interval.firstHalf() : interval.lastHalf(), 0.5f * entry.moved);
                continue;
            }
            const PreparedPiece& piece = state_.pieces->at(interval);
            if (piece.isForbidden) {
                answer_.isPair = false;
                meetContact(entry, interval);
                continue;
            }
            if (piece.counts == MotionPiece::Counts::kNowhere) continue;
            if (piece.counts == MotionPiece::Counts::kNotAtMiddle && entry.part == 0 &&
                entry.environment == 0 && interval.depth() < kMostHalvesForCounts &&
                movedBy(piece, Volume<kWidth>(part_, 0)) > leastMove(piece)) {
                push(entry, interval.lastHalf(), 0.5f * entry.moved);
                push(entry, interval.firstHalf(), 0.5f * entry.moved);
                continue;
            }
            look(entry, interval, piece);
        }
        finish();
    }

  private:
    /// Puts the whole motion on the stack.
    void begin() {
        begunAt_ = stop_;
        stack_.clear();
        stack_.push({0, kUnknownMove, 0, 0, TimeInterval().key});
    }

    /// Whether the caller wants no more, or there is no more memory.
    HWY_INLINE bool isToStop() {
        if (stack_.size() > request_.mostEntries) {
            answer_.isUndecided = true;
        } else if (--steps_ > 0) {
            return false;
        } else {
            steps_ = kStepsToStop;
            if (request_.isStopped == nullptr || !*request_.isStopped || !(*request_.isStopped)())
                return false;
            answer_.isStopped = true;
        }
        isDone_ = true;
        return true;
    }

    /// Distances in the middle of a piece must exceed this, query units. A least distance is looked for below the cap, then
    /// more and more closely below the least one found.
    double neededDouble(const PairQuery& query) const {
        double length = request_.margin;
        if (request_.goal == SweepGoal::kLeastDistance) {
            length += certified();
        }
        return (length + request_.poseError) * query.perMeshUnit;
    }

    /// kLeastDistance: what is certified where nothing is left open.
    double certified() const {
        if (isReached_) return leastUpper_ - request_.resolution.of(leastUpper_);
        return isNearCap_ ? request_.cap - request_.nearCap() : request_.cap;
    }

    /// For float, which proves no less than kLeastProved.
    float needed(const PairQuery& query) const {
        const double length = neededDouble(query);
        if (!(length > kLeastProved)) return nextFloatAbove(kLeastProved);
        return length < double(hwy::HighestValue<float>()) ? nextFloatAbove(length)
                                                           : hwy::HighestValue<float>();
    }

    HWY_INLINE void push(const SweepEntry& entry, TimeInterval interval, float moved) {
        stack_.push({entry.gap, moved, entry.part, entry.environment, interval.key});
    }

    HWY_INLINE void look(const SweepEntry& entry, TimeInterval interval, const PreparedPiece& piece) {
        const Volume<kWidth> a(part_, entry.part), b(environment_, entry.environment);
        const float sizeA = a.node.size[a.lane] * piece.query.partLeafToQuery,
                    sizeB = b.node.size[b.lane] * piece.query.environmentLeafToQuery;
        const float moved = entry.moved < kUnknownMove ? entry.moved : movedBy(piece, a);
        if (moved > kLongestMove * (sizeA > sizeB ? sizeA : sizeB) && interval.canBeHalved() &&
            moved > leastMove(piece)) {
            push(entry, interval.lastHalf(), 0.5f * moved);
            push(entry, interval.firstHalf(), 0.5f * moved);
        } else if (a.isLeaf() && b.isLeaf()) {
            meet(entry, interval, piece, a, b);
        } else if (OpensPart(piece.query, a, b)) {
            open<true>(entry, interval, piece, a, b);
        } else {
            open<false>(entry, interval, piece, a, b);
        }
    }

    /// Shorter moves are not looked into, query units.
    float leastMove(const PreparedPiece& piece) const {
        return float(0.5 * leastInterval_ * piece.query.perMeshUnit);
    }

    /// How far a point of a volume of the part moves in half the piece at most, query units.
    static HWY_INLINE float movedBy(const PreparedPiece& piece, const Volume<kWidth>& a) {
        const MovedField& field = piece.inPart;
        const auto at = [&](const float(&rows)[3][kWidth], int row) { return rows[row][a.lane]; };
        const float x = at(a.node.centre, 0), y = at(a.node.centre, 1), z = at(a.node.centre, 2);
        const float* w = field.turn;
        const float v[3] = {field.atOrigin[0] + w[1] * z - w[2] * y, field.atOrigin[1] + w[2] * x - w[0] * z,
                            field.atOrigin[2] + w[0] * y - w[1] * x};
        const float h0 = a.node.halfLength0[a.lane], h1 = a.node.halfLength1[a.lane];
        const float arm = std::sqrt(h0 * h0 + h1 * h1) + a.node.radius[a.lane] + field.bow;
        const float speed = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
        const float turn = std::sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
        return (speed + turn * arm + field.deviation) * piece.query.partLeafToQuery;
    }

    template <bool kOpenPart>
    HWY_INLINE void open(const SweepEntry& entry, TimeInterval interval, const PreparedPiece& piece,
                         const Volume<kWidth>& a, const Volume<kWidth>& b) {
        const PairQuery& query = piece.query;
        const Carry& carry = kOpenPart ? query.environmentToPart : query.partToEnvironment;
        const std::int32_t opened = kOpenPart ? a.child : b.child;
        const WideNode<kWidth>& node = (kOpenPart ? part_ : environment_).template nodes<kWidth>()[opened];
        const Volume<kWidth>& other = kOpenPart ? b : a;
        const CarriedRss one = CarryVolume(carry, other.node, other.lane);
        const MovedField& field = kOpenPart ? piece.inPart : piece.inEnvironment;
        const NearChildren near = MovingRssBounds<kOpenPart>(one, node, field, carry.slack, carry.toQueryUnit,
                                                             needed(query), bounds_);
        ++state_.counters.nodeVisits;
        state_.counters.volumeTests += near.children;
        const std::size_t base = stack_.size();
        for (std::uint32_t left = near.lanes; left != 0; left &= left - 1) {
            const std::uint32_t lane = LowestBit(left);
            const VolumeReference child = VolumeReference(opened) * kWidth + lane;
            const SweepEntry added{bounds_.gap[lane], bounds_.moved[lane], kOpenPart ? child : entry.part,
                                   kOpenPart ? entry.environment : child, entry.interval};
            const float after = bounds_.after[lane], before = bounds_.before[lane];
            if (after < kShareToCutOff && before < kShareToCutOff) {
                pushSorted(added, base);
            } else {
                pushRest(added, interval, after, before, base);
            }
        }
    }

    /// The nearest comes last.
    HWY_INLINE void pushSorted(const SweepEntry& added, std::size_t base) {
        stack_.push(added);
        std::size_t place = stack_.size() - 1;
        for (; place > base && stack_[place - 1].gap < added.gap; --place) stack_[place] = stack_[place - 1];
        stack_[place] = added;
    }

    /// Keeps the time that the shares leave open: on each side the shortest dyadic interval that holds it.
    void pushRest(SweepEntry added, TimeInterval interval, float after, float before, std::size_t base) {
        if (after < kWholeShare) pushHalf<true>(added, interval.lastHalf(), after, base);
        if (before < kWholeShare) pushHalf<false>(added, interval.firstHalf(), before, base);
    }

    template <bool kIsLast>
    HWY_INLINE void pushHalf(SweepEntry added, TimeInterval rest, float certified, std::size_t base) {
        constexpr float kRounded = 1 - 0x1p-20f;  // a share may be this much too large
        added.moved *= 0.5f;
        for (float open = 1 - certified * kRounded; open <= 0.5f && rest.canBeHalved(); open *= 2) {
            rest = kIsLast ? rest.lastHalf() : rest.firstHalf();
            added.moved *= 0.5f;
        }
        added.interval = rest.key;
        pushSorted(added, base);
    }

    /// The share of a pair of leaves that is certified, as far as its pairs of triangles have been looked at.
    struct LeafShares {
        float after = hwy::HighestValue<float>(), before = hwy::HighestValue<float>();
        double lower = hwy::HighestValue<double>();  ///< of the pairs' distances, query units
        bool isContact = false;
        TrianglesAt contact;
        void lessen(float afterShare, float beforeShare) {
            if (!(afterShare >= after)) after = afterShare;
            if (!(beforeShare >= before)) before = beforeShare;
        }
    };

    HWY_INLINE void meet(const SweepEntry& entry, TimeInterval interval, const PreparedPiece& piece,
                         const Volume<kWidth>& a, const Volume<kWidth>& b) {
        const Leaf partLeaf = part_.leaf(a.leaf()), environmentLeaf = environment_.leaf(b.leaf());
        const float moved = movedBy(piece, a);
        const float need = needed(piece.query);
        const MovedField field = piece.fieldAbout(
            {environmentLeaf.centre[0], environmentLeaf.centre[1], environmentLeaf.centre[2]});
        leaves_.meet(piece.query, partLeaf, environmentLeaf, -hwy::HighestValue<float>(),
                     (need + piece.deviation) * kWholeShare,
                     [&](const float(&between)[3], float radius)
                         HWY_ATTR { return LeafMove(field, between, radius); });
        state_.counters.triangleTests += std::uint64_t(leaves_.total());
        state_.counters.triangleLanes += std::uint64_t(leaves_.lanes());
        LeafShares shares;
        leaves_.visitRegisters([&](const PairTag& d, const TrianglePair<hn::Vec<PairTag>>& pair,
                                   const LeafPairs::RegisterPlace& place) HWY_ATTR {
            lookAt(d, pair, place, piece, need, field, shares);
            return !shares.isContact && !isDone_;
        });
        if (shares.isContact) {
            answer_.isPair = true;
            answer_.contact = shares.contact;
            meetContact(entry, interval);
        } else if (isDone_) {
            stack_.push(entry);  // stopped amid the leaves: the interval is open
        } else if (shares.after < kWholeShare || shares.before < kWholeShare) {
            if (moved <= leastMove(piece) || !interval.canBeHalved()) {
                giveUp(interval, shares.lower - moved, piece);
            } else {
                SweepEntry rest = entry;
                rest.moved = moved;
                pushRest(rest, interval, shares.after, shares.before, stack_.size());
            }
        }
    }

    template <class V = hn::Vec<PairTag>>
    HWY_INLINE void lookAt(const PairTag& d, const TrianglePair<V>& pair,
                           const LeafPairs::RegisterPlace& place, const PreparedPiece& piece, float need,
                           const MovedField& field, LeafShares& leaf) {
        const float error = leaves_.roundingError();
        const MovingTriangles<V> found =
            CertifyMovingTriangles(d, pair, place.near, hn::Set(d, need + error), TriangleField<V>(d, field));
        std::uint32_t left = found.left;
        if (left == 0) return;
        // A least distance wants the distances of certified pairs, too.
        if (request_.goal != SweepGoal::kLeastDistance) left &= ~WholeLanes(d, found.shares);
        alignas(64) float lowers[kBlockPairs], uppers[kBlockPairs], features[kBlockPairs],
            afters[kBlockPairs], befores[kBlockPairs];
        hn::Store(found.bounds.feature, d, features);
        hn::Store(hn::Sub(found.bounds.lower, hn::Set(d, error)), d, lowers);
        hn::Store(hn::Add(found.bounds.upper, hn::Set(d, error)), d, uppers);
        hn::Store(found.shares.after, d, afters);
        hn::Store(found.shares.before, d, befores);
        for (; left != 0 && !leaf.isContact && !isDone_; left &= left - 1) {
            const std::uint32_t lane = LowestBit(left);
            take({lowers[lane], uppers[lane], afters[lane], befores[lane]},
                 leaves_.trianglesAt(place, lane, std::int32_t(features[lane])), piece, need, leaf);
        }
    }

    /// Bounds and shares of a pair of triangles, as proved by float. Query units.
    struct FloatPair {
        float lower, upper, after, before;
    };

    HWY_INLINE void take(const FloatPair& pair, const TrianglesAt& triangles, const PreparedPiece& piece,
                         float need, LeafShares& leaf) {
        const bool isWide = !(pair.upper - pair.lower <= kTooWide * (pair.upper - need));
        if (request_.goal == SweepGoal::kLeastDistance) {
            reach(pair.upper, triangles, piece);
        } else {
            const double margin = request_.margin * piece.query.perMeshUnit;
            const bool isWithin = double(pair.upper) <= margin && pair.upper > kLeastProved
                                      ? true
                                      : !(double(pair.lower) > margin && pair.lower > kLeastProved) &&
                                            isExactlyWithin(triangles, piece);
            if (isWithin && piece.counts == MotionPiece::Counts::kAtMiddle) {
                leaf.isContact = true;
                leaf.contact = triangles;
                return;
            }
            if (isWithin) return leaf.lessen(0, 0);
        }
        if (!isWide) {
            leaf.lower = leaf.lower < double(pair.lower) ? leaf.lower : double(pair.lower);
            leaf.lessen(pair.after, pair.before);
        } else {
            resolve(triangles, piece, leaf);
        }
    }

    bool isExactlyWithin(const TrianglesAt& triangles, const PreparedPiece& piece) {
        countStep();
        return isPairWithin(piece.query, triangles, request_.margin, state_.counters).within;
    }

    /// Certifies a pair in double.
    HWY_NOINLINE void resolve(const TrianglesAt& triangles, const PreparedPiece& piece, LeafShares& leaf) {
        countStep();
        ++state_.counters.refinedPairs;
        const ResolvedPair pair = resolvePair(piece.query, triangles);
        if (request_.goal == SweepGoal::kLeastDistance) reach(pair.upper, triangles, piece);
        leaf.lower = leaf.lower < pair.lower ? leaf.lower : pair.lower;
        const MovedShares shares = sharesInDouble(piece, triangles, pair, neededDouble(piece.query));
        leaf.lessen(shares.after, shares.before);
    }

    /// Takes a distance that a pair has in the middle of a piece. Query units.
    HWY_INLINE void reach(double upper, const TrianglesAt& triangles, const PreparedPiece& piece) {
        if (piece.counts != MotionPiece::Counts::kAtMiddle) return;
        const double clearance = upper / piece.query.perMeshUnit - request_.margin;
        if (!(clearance < leastUpper_)) {
            isNearCap_ = isNearCap_ || clearance - request_.cap < request_.nearCap();
            return;
        }
        leastUpper_ = clearance;
        isReached_ = true;
        answer_.nearest = {clearance, TimeInterval{piece.key}.middle(), triangles};
        endIfNear();
    }

    /// Distances within the margin, or hardly beyond it, need not be known better.
    void endIfNear() {
        if (isReached_ && leastUpper_ <= request_.resolution.of(leastUpper_)) isDone_ = true;
    }

    void countStep() {
        if (isToStop()) isDone_ = true;
    }

    void meetContact(const SweepEntry& entry, TimeInterval interval) {
        const double time = interval.middle();
        contactTime_ = time;
        answer_.isContact = true;
        if (request_.goal != SweepGoal::kForward) {
            isDone_ = true;
        } else {
            stop_ = interval.canBeHalved() ? time : interval.from();
            if (time <= 0.5 * begunAt_) {
                begin();  // most of what waits was opened for later times
            } else if (interval.canBeHalved()) {
                push(entry, interval.firstHalf(), 0.5f * entry.moved);
            }
        }
    }

    /// An interval so short is left open. lower: of the pair's distances in it, query units.
    void giveUp(TimeInterval interval, double lower, const PreparedPiece& piece) {
        if (request_.goal == SweepGoal::kLeastDistance) {
            const double proved = lower / piece.query.perMeshUnit - request_.poseError;
            const double clearance = (proved > 0 ? proved : 0) - request_.margin;
            openLower_ = openLower_ < clearance ? openLower_ : clearance;
            return;
        }
        stop_ = stop_ < interval.from() || request_.goal != SweepGoal::kForward ? stop_ : interval.from();
        // Only contact is of interest now, and that is found in the middle of longer intervals.
        if (!answer_.isUndecided && request_.goal == SweepGoal::kCertify) leastInterval_ *= kCoarser;
        answer_.isUndecided = true;
    }

    void finish() {
        for (const SweepEntry& left : stack_) {
            const double from = TimeInterval{left.interval}.from();
            stop_ = stop_ < from ? stop_ : from;
        }
        answer_.certifiedUntil = stop_ > request_.from ? stop_ : request_.from;
        answer_.contactTime = contactTime_;
        answer_.isContact = answer_.isContact || (request_.isContactAtEnd && stop_ < request_.until);
        answer_.lower = std::fmin(certified(), openLower_);
        if (isDone_) answer_.lower = -request_.margin;
        state_.counters.kernelPairs += leaves_.kernelPairs();
        state_.counters.kernelLanes += leaves_.kernelLanes();
    }

    const FlatTree& part_;
    const FlatTree& environment_;
    const SweepRequest& request_;
    Workspace::State& state_;
    Pile<SweepEntry>& stack_;
    SweepAnswer& answer_;
    LeafPairs leaves_;
    MovingBounds<kWidth> bounds_;
    double stop_;         ///< later times do not matter any more
    double contactTime_;  ///< of the first pose in contact known so far
    double leastUpper_;   ///< kLeastDistance: of the distances less the margin
    double leastInterval_;
    double begunAt_ = 1;  ///< stop_ when the whole motion was put on the stack
    double openLower_ = std::numeric_limits<double>::infinity();  ///< kLeastDistance: of what was left open
    int steps_ = 1;   ///< to the next look at isStopped, which comes at once
    bool isReached_;  ///< kLeastDistance: leastUpper_ is a distance found, not the cap
    bool isNearCap_ = false;
    bool isDone_ = false;
};

}  // namespace HWY_NAMESPACE
}  // namespace clearway
HWY_AFTER_NAMESPACE();

#endif
