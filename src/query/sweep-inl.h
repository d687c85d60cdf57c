// The traversal of a sweep: depth first through pairs of volumes and intervals of time. A pair is looked at in the middle of
// its interval, where its gap certifies a share of the interval's halves; what that leaves open is kept for later, as shorter
// intervals of the pair or of the children of one of its volumes. A pair of leaves is divided in time only.
#include <cmath>
#include <limits>

#include "hwy/highway.h"
#include "kernels/moving_rss_bound-inl.h"
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

/// The lengths that a register's triangles of the part move in half a piece: one for each corner.
template <class V>
struct CornerMoves {
    Lanes3<V> of[3];
    Lanes3<V> turn;
    V deviation, bow;
};

/// How far the corners of the part's triangles move in half a piece, about the centre of the environment's leaf; query units.
struct TriangleMove {
    static constexpr bool kIsNone = false;
    float origin[3], turn[3];  ///< a point at y moves by origin + turn x y
    float bow;                 ///< as in MovedField
    float nearingLeaves =
        0;  ///< of all triangles of the part's leaf, along the line between the leaves' centres

    template <class V>
    HWY_INLINE V nearing(const Lanes3<V>& v, const Triangles<V>& a) const {
        const PairTag d;
        const Lanes3<V> at = {hn::Set(d, origin[0]), hn::Set(d, origin[1]), hn::Set(d, origin[2])};
        const Lanes3<V> spin = {hn::Set(d, turn[0]), hn::Set(d, turn[1]), hn::Set(d, turn[2])};
        const Lanes3<V> across = Cross(v, spin);
        const V along = Dot(v, at);
        V most = hn::Zero(d);
        for (const Lanes3<V>& corner : a.corner)
            most = hn::Max(most, hn::Abs(hn::Add(along, Dot(across, corner))));
        return hn::MulAdd(hn::Sqrt(Dot(across, across)), hn::Set(d, bow), most);
    }
};

/// Certifies pairs of triangles along v and raises `lower` to the gap found.
template <class D, class V = hn::Vec<D>>
HWY_INLINE void CertifyTrianglesAlong(D d, const Lanes3<V>& v, const TrianglePair<V>& pair, V needed,
                                      const CornerMoves<V>& moves, V& lower, CertifiedShares<V>& shares) {
    const V a0 = Dot(v, pair.a.corner[0]), a1 = Dot(v, pair.a.corner[1]), a2 = Dot(v, pair.a.corner[2]);
    const V b0 = Dot(v, pair.b.corner[0]), b1 = Dot(v, pair.b.corner[1]), b2 = Dot(v, pair.b.corner[2]);
    const V m0 = Dot(v, moves.of[0]), m1 = Dot(v, moves.of[1]), m2 = Dot(v, moves.of[2]);
    const V above = hn::Sub(hn::Min(b0, hn::Min(b1, b2)), hn::Max(a0, hn::Max(a1, a2)));
    const V below = hn::Sub(hn::Min(a0, hn::Min(a1, a2)), hn::Max(b0, hn::Max(b1, b2)));
    const V up = hn::Max(m0, hn::Max(m1, m2)), down = hn::Neg(hn::Min(m0, hn::Min(m1, m2)));
    const auto isAbove = hn::Ge(above, below);
    const V lengthSquared = Dot(v, v);
    const auto usable = IsUsableToMove(d, lengthSquared);
    const V inverse = hn::Div(hn::Set(d, 1.0f), hn::Sqrt(lengthSquared));
    const V gap = hn::IfThenElse(usable, hn::Mul(hn::IfThenElse(isAbove, above, below), inverse),
                                 hn::Set(d, -hwy::HighestValue<float>()));
    const Lanes3<V> spin = Cross(v, moves.turn);
    const V bowed = hn::Mul(hn::Sqrt(Dot(spin, spin)), moves.bow);
    const V forwards =
        hn::MulAdd(hn::Add(hn::IfThenElse(isAbove, up, down), bowed), inverse, moves.deviation);
    const V backwards =
        hn::MulAdd(hn::Add(hn::IfThenElse(isAbove, down, up), bowed), inverse, moves.deviation);
    const V room = hn::Sub(gap, needed);
    lower = hn::Max(lower, gap);
    shares.raise(ShareOf(d, room, forwards), ShareOf(d, room, backwards));
}

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
          contactTime_(request.isContactAtEnd ? request.until : hwy::HighestValue<double>()),
          leastUpper_(request.leastUpper),
          leastInterval_(request.leastInterval) {
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
            if (contactTime_ - interval.from() <= request_.contactTime) {
                stop_ = interval.from();
                continue;
            }
            const double middle = interval.middle();
            if ((middle >= stop_ || middle <= request_.from) && interval.canBeHalved()) {
                push(entry, middle >= stop_ ? interval.firstHalf() : interval.lastHalf(), 0.5f * entry.moved);
                continue;
            }
            const PreparedPiece& piece = state_.pieces->at(interval);
            if (piece.counts == MotionPiece::Counts::kNowhere) continue;
            if (piece.counts == MotionPiece::Counts::kNotAtMiddle && entry.part == 0 &&
                entry.environment == 0 && interval.depth() < kMostHalvesForCounts) {
                push(entry, interval.lastHalf(), 0.5f * entry.moved);
                push(entry, interval.firstHalf(), 0.5f * entry.moved);
                continue;
            }
            if (piece.isForbidden) {
                answer_.isPair = false;
                meetContact(entry, interval);
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

    /// What distances in the middle of a piece must exceed, query units. A least distance is looked for below the cap, then
    /// more and more closely below the least one found.
    double neededDouble(const PairQuery& query) const {
        double length = request_.margin;
        if (request_.goal == SweepGoal::kLeastDistance) {
            length += isReached_ ? leastUpper_ - request_.resolution.of(leastUpper_) : leastUpper_;
        }
        return (length + request_.poseError) * query.perMeshUnit;
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

    /// Keeps what the shares leave open, each side as the shortest dyadic interval that holds it.
    HWY_INLINE void pushRest(SweepEntry added, TimeInterval interval, float after, float before,
                             std::size_t base) {
        constexpr float kRounded = 1 - 0x1p-20f;  // a share may be this much too large
        const float moved = 0.5f * added.moved;
        if (after < kWholeShare) {
            TimeInterval rest = interval.lastHalf();
            added.moved = moved;
            for (float open = 1 - after * kRounded; open <= 0.5f && rest.canBeHalved(); open *= 2) {
                rest = rest.lastHalf();
                added.moved *= 0.5f;
            }
            added.interval = rest.key;
            pushSorted(added, base);
        }
        if (before < kWholeShare) {
            TimeInterval rest = interval.firstHalf();
            added.moved = moved;
            for (float open = 1 - before * kRounded; open <= 0.5f && rest.canBeHalved(); open *= 2) {
                rest = rest.firstHalf();
                added.moved *= 0.5f;
            }
            added.interval = rest.key;
            pushSorted(added, base);
        }
    }

    /// The share of a pair of leaves that is certified, as far as its pairs of triangles have been looked at.
    struct LeafShares {
        float after = hwy::HighestValue<float>(), before = hwy::HighestValue<float>();
        double lower = hwy::HighestValue<double>();  ///< of the pairs' distances, query units
        bool isContact = false;
        TrianglesAt contact{0, 0, kNoFeature};
        void lessen(float afterShare, float beforeShare) {
            if (!(afterShare >= after)) after = afterShare;
            if (!(beforeShare >= before)) before = beforeShare;
        }
    };

    HWY_INLINE void meet(const SweepEntry& entry, TimeInterval interval, const PreparedPiece& piece,
                         const Volume<kWidth>& a, const Volume<kWidth>& b) {
        const Leaf &partLeaf = part_.leaves[~a.child], &environmentLeaf = environment_.leaves[~b.child];
        const float moved = movedBy(piece, a);
        const float need = needed(piece.query);
        const Vector3 centre(environmentLeaf.centre[0], environmentLeaf.centre[1], environmentLeaf.centre[2]);
        TriangleMove move;
        fieldAt(piece, centre, move.origin, move.turn);
        move.bow = piece.bow;
        leaves_.meet(piece.query, partLeaf, environmentLeaf, -hwy::HighestValue<float>(),
                     (need + piece.deviation) * kWholeShare,
                     [&](const float(&offset)[3], float radius) HWY_ATTR {
                         move.nearingLeaves = nearingOf(move, offset, radius);
                         return move;
                     });
        state_.counters.triangleTests += std::uint64_t(leaves_.total());
        state_.counters.triangleLanes += std::uint64_t(leaves_.lanes());
        LeafShares shares;
        leaves_.visitRegisters([&](const PairTag& d, const TrianglePair<hn::Vec<PairTag>>& pair,
                                   const LeafPairs::RegisterPlace& place) HWY_ATTR {
            lookAt(d, pair, place, piece, need, move, shares);
            return !shares.isContact && !isDone_;
        });
        if (shares.isContact) {
            answer_.isPair = true;
            answer_.contact = shares.contact;
            meetContact(entry, interval);
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

    /// The moves of points about a point of the environment, query units.
    static void fieldAt(const PreparedPiece& piece, const Vector3& centre, float (&field)[3],
                        float (&turn)[3]) {
        const PairQuery& query = piece.query;
        const Vector3 from = centre - Vector3(query.t[0], query.t[1], query.t[2]);
        const Vector3 moved = (piece.velocity + piece.turn.cross(from)) * query.perMeshUnit;
        for (int row = 0; row < 3; ++row) {
            field[row] = static_cast<float>(moved[row]);
            turn[row] = static_cast<float>(piece.turn[row]);
        }
    }

    /// How far points of a leaf move along the line from its centre to the environment leaf's, times the line's length.
    /// offset: the part leaf's centre.
    static HWY_INLINE float nearingOf(const TriangleMove& move, const float (&offset)[3], float radius) {
        const float *w = move.turn, *o = offset;
        const float spin[3] = {w[1] * o[2] - w[2] * o[1], w[2] * o[0] - w[0] * o[2],
                               w[0] * o[1] - w[1] * o[0]};
        const float along = move.origin[0] * o[0] + move.origin[1] * o[1] + move.origin[2] * o[2];
        const float across = std::sqrt(spin[0] * spin[0] + spin[1] * spin[1] + spin[2] * spin[2]);
        return std::fabs(along) + across * (radius + move.bow);
    }

    template <class V = hn::Vec<PairTag>>
    HWY_INLINE void lookAt(const PairTag& d, const TrianglePair<V>& pair,
                           const LeafPairs::RegisterPlace& place, const PreparedPiece& piece, float need,
                           const TriangleMove& move, LeafShares& leaf) {
        const float error = leaves_.roundingError();
        const Lanes3<V> origin = {hn::Set(d, move.origin[0]), hn::Set(d, move.origin[1]),
                                  hn::Set(d, move.origin[2])};
        const Lanes3<V> spin = {hn::Set(d, move.turn[0]), hn::Set(d, move.turn[1]), hn::Set(d, move.turn[2])};
        CornerMoves<V> moves;
        for (int k = 0; k < 3; ++k) moves.of[k] = origin + Cross(spin, pair.a.corner[k]);
        moves.turn = spin;
        moves.deviation = hn::Set(d, piece.deviation);
        moves.bow = hn::Set(d, piece.bow);
        const V neededGap = hn::Set(d, need + error);
        V lower = hn::Set(d, -hwy::HighestValue<float>());
        CertifiedShares<V> shares = {hn::Zero(d), hn::Zero(d)};
        const auto open = [&] HWY_ATTR {
            return place.near &
                   ~MaskBits(d, hn::Ge(hn::Min(shares.after, shares.before), hn::Set(d, kWholeShare)));
        };
        CertifyTrianglesAlong(d, pair.normalA, pair, neededGap, moves, lower, shares);
        CertifyTrianglesAlong(d, pair.normalB, pair, neededGap, moves, lower, shares);
        std::uint32_t left = open();
        if (left == 0) return;
        const TriangleBounds<V> bounds = TriangleDistance(d, pair, lower);
        CertifyTrianglesAlong(d, bounds.difference, pair, neededGap, moves, lower, shares);
        const Lanes3<V> mean = moves.of[0] + moves.of[1] + moves.of[2];
        const V along = hn::Div(Dot(bounds.difference, mean), Dot(mean, mean));
        CertifyTrianglesAlong(d, AddScaled(bounds.difference, hn::Neg(along), mean), pair, neededGap, moves,
                              lower, shares);
        if (request_.goal != SweepGoal::kLeastDistance) left = open();
        alignas(64) float lowers[kBlockPairs], uppers[kBlockPairs], features[kBlockPairs],
            afters[kBlockPairs], befores[kBlockPairs];
        hn::Store(bounds.feature, d, features);
        hn::Store(hn::Sub(bounds.lower, hn::Set(d, error)), d, lowers);
        hn::Store(hn::Add(bounds.upper, hn::Set(d, error)), d, uppers);
        hn::Store(shares.after, d, afters);
        hn::Store(shares.before, d, befores);
        for (; left != 0 && !leaf.isContact && !isDone_; left &= left - 1) {
            const std::uint32_t lane = LowestBit(left);
            take({lowers[lane], uppers[lane], afters[lane], befores[lane]},
                 leaves_.trianglesAt(place, lane, features[lane]), piece, need, leaf);
        }
    }

    /// What float knows about a pair of triangles. Query units.
    struct FloatPair {
        float lower, upper, after, before;
    };

    HWY_INLINE void take(const FloatPair& pair, const TrianglesAt& triangles, const PreparedPiece& piece,
                         float need, LeafShares& leaf) {
        const bool isWide = !(pair.upper - pair.lower <= kTooWide * (pair.upper - need));
        if (request_.goal == SweepGoal::kLeastDistance) {
            reach(pair.upper, piece);
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
        if (request_.goal == SweepGoal::kLeastDistance) reach(pair.upper, piece);
        leaf.lower = leaf.lower < pair.lower ? leaf.lower : pair.lower;
        const MovedShares shares = sharesInDouble(piece, triangles, pair, neededDouble(piece.query));
        leaf.lessen(shares.after, shares.before);
    }

    /// Takes a distance that a pose of the motion has. Query units.
    HWY_INLINE void reach(double upper, const PreparedPiece& piece) {
        if (piece.counts != MotionPiece::Counts::kAtMiddle) return;
        const double clearance = upper / piece.query.perMeshUnit - request_.margin;
        if (!(clearance < leastUpper_)) return;
        leastUpper_ = clearance;
        isReached_ = true;
        answer_.time = TimeInterval{piece.key}.middle();
        // Distances within the margin, or too short to be told from 0, need not be known better.
        if (leastUpper_ <= 0 || leastUpper_ + request_.margin <= request_.resolution.of(leastUpper_))
            isDone_ = true;
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
            stop_ = time;
            if (time <= 0.5 * begunAt_) {
                begin();  // most of what waits was opened for later times
            } else {
                push(entry, interval.firstHalf(), 0.5f * entry.moved);
            }
        }
    }

    /// An interval so short is left open. lower: of the pair's distances in it, query units.
    void giveUp(TimeInterval interval, double lower, const PreparedPiece& piece) {
        if (request_.goal == SweepGoal::kLeastDistance) {
            const double clearance = (lower > 0 ? lower : 0) / piece.query.perMeshUnit - request_.margin;
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
        answer_.upper = leastUpper_;
        const double certified = isReached_ ? leastUpper_ - request_.resolution.of(leastUpper_) : leastUpper_;
        answer_.lower = certified < openLower_ ? certified : openLower_;
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
    int steps_ = 1;           ///< to the next look at isStopped, which comes at once
    bool isReached_ = false;  ///< kLeastDistance: leastUpper_ is a distance found, not the cap
    bool isDone_ = false;
};

}  // namespace HWY_NAMESPACE
}  // namespace clearway
HWY_AFTER_NAMESPACE();

#endif
