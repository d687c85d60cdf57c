// All pairs of triangles of two leaves, one pair per lane. A cheap bound drops most pairs; the others go
// through the visitor's triangle kernel, at once or with the pairs of other leaves.
#include "clearway/build_options.h"
#include "hwy/highway.h"
#include "kernels/tri_tri_distance-inl.h"
#include "query/pair_query.h"
#include "query/waiting_pairs-inl.h"

#if defined(CLEARWAY_QUERY_LEAF_PAIRS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARWAY_QUERY_LEAF_PAIRS_INL_H_
#undef CLEARWAY_QUERY_LEAF_PAIRS_INL_H_
#else
#define CLEARWAY_QUERY_LEAF_PAIRS_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace clearway {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// A leaf is cut into blocks of up to 4 triangles. Two blocks make 16 pairs: pair p consists of triangle p /
/// 4 of the part's block and triangle p % 4 of the environment's.
constexpr int kBlock = 4;
constexpr int kBlockPairs = kBlock * kBlock;
constexpr int kMostBlocks = (kLargestLeafSize + kBlock - 1) / kBlock;  ///< in a leaf
constexpr int kWalkSteps = 1;  ///< of the cheap bound; a second one drops a third of the rest, but costs more
static_assert(hn::MaxLanes(PairTag()) <= kBlockPairs);

/// Registers with at least this many near pairs go to the kernel at once: gathering them would cost more than the empty lanes.
constexpr std::size_t kCrowded = (3 * hn::MaxLanes(PairTag()) + 3) / 4;

/// One coordinate of a block's 4 triangles. Entries past the block's last triangle have no meaning.
struct alignas(16) BlockRow {
    float of[kBlock];
};

/// The row of an environment block spread over a register, each triangle in the lanes of its pairs. first:
/// the pair in the first lane.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V SpreadEnvironment(D d, const float* row, [[maybe_unused]] size_t first) {
#if HWY_TARGET == HWY_SCALAR
    return hn::Set(d, row[first % kBlock]);
#else
    return hn::LoadDup128(d, row);
#endif
}

/// The row of a part block spread over a register in this way.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V SpreadPart(D d, const BlockRow& row, size_t first) {
#if HWY_TARGET != HWY_SCALAR
    if constexpr (hn::MaxLanes(D()) > kBlock) {
        alignas(64) static constexpr std::int32_t kTriangleOfPair[kBlockPairs] = {0, 0, 0, 0, 1, 1, 1, 1,
                                                                                  2, 2, 2, 2, 3, 3, 3, 3};
        return hn::TableLookupLanes(hn::LoadDup128(d, row.of),
                                    hn::SetTableIndices(d, kTriangleOfPair + first));
    }
#endif
    return hn::Set(d, row.of[first / kBlock]);
}

/// Two leaves in the environment's axes, relative to the environment leaf's centre, in query units. The
/// corners are then numbers of the leaves' size at any distance from the origin, and the rounding error is in
/// proportion.
class LeafPairs {
  public:
    /// Brings two leaves together, which must outlive the visit, and finds the pairs that a cheap bound does not drop. volumesBound: a
    /// proved lower bound of all pairs' distances. moves: called with across() and the part leaf's radius, returns what
    /// WalkProvesApart takes as move.
    template <class Moves>
    HWY_INLINE void meet(const PairQuery& query, const Leaf& part, const Leaf& environment,
                         float volumesBound, float dropFrom, const Moves& moves) {
        query_ = &query;
        part_ = &part;
        environment_ = &environment;
        volumesBound_ = volumesBound;
        double away = 0;  // at least the offset's length
        for (int row = 0; row < 3; ++row) {
            const double* R = query.R + 3 * row;
            const double between = (R[0] * part.centre[0] + R[1] * part.centre[1] + R[2] * part.centre[2] +
                                    query.t[row] - environment.centre[row]) *
                                   query.perMeshUnit;
            offset_[row] = static_cast<float>(between);
            away += __builtin_fabs(between);
        }
        const double reach = double(part.radius) * query.partLeafToQuery +
                             double(environment.radius) * query.environmentLeafToQuery + away;
        roundingError_ = slackOf(kTriangleSlack, reach, query.offsetSlack);
        const auto move = moves(offset_, part.radius * query.partLeafToQuery);
        int block = 0;
        for (std::uint32_t i = 0; i < part.triangleCount; i += kBlock) {
            const BlockStart partStart = movePart(i);
            for (std::uint32_t j = 0; j < environment.triangleCount; j += kBlock) {
                near_[block++] = cull(i, j, partStart, dropFrom, move);
            }
        }
    }

    HWY_INLINE void meet(const PairQuery& query, const Leaf& part, const Leaf& environment,
                         float volumesBound, float dropFrom) {
        meet(query, part, environment, volumesBound, dropFrom,
             [](const float(&)[3], float) { return NoMove(); });
    }

    int total() const { return int(part_->triangleCount * environment_->triangleCount); }

    /// Places for pairs in the blocks of these leaves.
    int lanes() const {
        return int((part_->triangleCount + kBlock - 1) / kBlock *
                   ((environment_->triangleCount + kBlock - 1) / kBlock)) *
               kBlockPairs;
    }

    /// Pairs that came to the visitor's kernel, over all leaves met so far, and the lanes of their registers.
    std::uint64_t kernelPairs() const { return kernelPairs_; }
    std::uint64_t kernelLanes() const { return kernelLanes_; }

    /// Hands the near pairs to the visitor, as TakeNear does: crowded registers at once, other pairs when they and
    /// the waiting ones fill a register. The remaining pairs wait.
    template <class Visitor>
    HWY_INLINE void visit(WaitingPairs& waiting, Visitor& visitor) {
        visitPlaces([&](const RegisterPlace& place) HWY_ATTR {
            if (Visitor::kPairsMayWait && hwy::PopCount(std::uint64_t(place.near)) < kCrowded) {
                append(place, waiting);
                return !waiting.fillRegister() || waiting.take(visitor);
            }
            const RegisterOfPairs pairs = {loadPairs(place), place.near, hn::Set(PairTag(), roundingError_),
                                           hn::Set(PairTag(), volumesBound_)};
            return TakeNear(pairs, visitor, [&](std::uint32_t lane, std::int32_t feature) {
                return trianglesAt(place, lane, feature);
            });
        });
    }

    /// Hands the visitor the near pairs of these leaves alone.
    template <class Visitor>
    HWY_INLINE void visit(Visitor& visitor) {
        WaitingPairs waiting;
        visit(waiting, visitor);
        if (!visitor.done() && waiting.count > 0) waiting.take(visitor);
    }

    /// The place of a register among the pairs of two leaves: its blocks begin with the part's triangle i and
    /// the environment's triangle j, its first lane holds pair `first`. near: the lanes that meet() left, as
    /// bits.
    struct RegisterPlace {
        std::uint32_t i, j, first, near;
    };

    /// Calls look(d, pair, place) for every register that holds a near pair, until it returns false.
    template <class Look>
    HWY_INLINE void visitRegisters(const Look& look) {
        visitPlaces([&](const RegisterPlace& place)
                        HWY_ATTR { return look(PairTag(), loadPairs(place), place); });
    }

    /// The pair in a lane of a register.
    TrianglesAt trianglesAt(const RegisterPlace& place, std::uint32_t lane, std::int32_t feature) const {
        const std::uint32_t pair = place.first + lane;
        return {{part_->at, place.i + pair / kBlock}, {environment_->at, place.j + pair % kBlock}, feature};
    }

    /// Rounding of a gap or distance of these leaves' triangles, query units.
    float roundingError() const { return roundingError_; }

  private:
    /// Where the walk between triangles starts: for each triangle of a block, the corner farthest towards the
    /// other leaf's centre, and its coordinate along that direction.
    struct BlockStart {
        BlockRow corner[3];
        BlockRow along;
    };

    template <class D, class V>
    static HWY_INLINE void store(D d, const SupportCorner<V>& support, BlockStart& start, size_t i) {
        hn::Store(support.corner.x, d, start.corner[0].of + i);
        hn::Store(support.corner.y, d, start.corner[1].of + i);
        hn::Store(support.corner.z, d, start.corner[2].of + i);
        hn::Store(support.along, d, start.along.of + i);
    }

    /// The vector from the part leaf's centre to the environment leaf's centre.
    template <class D, class V = hn::Vec<D>>
    HWY_INLINE Lanes3<V> across(D d) const {
        return {hn::Set(d, -offset_[0]), hn::Set(d, -offset_[1]), hn::Set(d, -offset_[2])};
    }

    /// Moves the part's block that begins with triangle `first`.
    HWY_INLINE BlockStart movePart(std::uint32_t first) {
        const hn::CappedTag<float, kBlock> d;
        using V = hn::Vec<decltype(d)>;
        const std::uint32_t n = part_->triangleCount;
        const float* stored = part_->offsets + first;
        const auto scale = hn::Set(d, query_->partLeafToQuery);
        BlockStart start;
        for (size_t i = 0; i < kBlock; i += hn::Lanes(d)) {
            Triangles<V> moved;
            for (int corner = 0; corner < 3; ++corner) {
                const float* from = stored + 3 * corner * n + i;
                const auto x = hn::Mul(hn::LoadU(d, from), scale);
                const auto y = hn::Mul(hn::LoadU(d, from + n), scale);
                const auto z = hn::Mul(hn::LoadU(d, from + 2 * n), scale);
                const auto coordinate = [&](int row) HWY_ATTR {
                    const float* R = query_->rotation + 3 * row;
                    auto sum = hn::MulAdd(hn::Set(d, R[2]), z, hn::Set(d, offset_[row]));
                    sum = hn::MulAdd(hn::Set(d, R[1]), y, sum);
                    sum = hn::MulAdd(hn::Set(d, R[0]), x, sum);
                    hn::Store(sum, d, moved_[first / kBlock][3 * corner + row].of + i);
                    return sum;
                };
                moved.corner[corner] = {coordinate(0), coordinate(1), coordinate(2)};
            }
            store(d, Support<false>(across(d), moved), start, i);
        }
        return start;
    }

    HWY_INLINE BlockStart startOfEnvironment(std::uint32_t first) const {
        const hn::CappedTag<float, kBlock> d;
        using V = hn::Vec<decltype(d)>;
        const std::uint32_t n = environment_->triangleCount;
        const float* stored = environment_->offsets + first;
        const auto scale = hn::Set(d, query_->environmentLeafToQuery);
        BlockStart start;
        for (size_t i = 0; i < kBlock; i += hn::Lanes(d)) {
            Triangles<V> triangles;
            for (int corner = 0; corner < 3; ++corner) {
                const auto coordinate = [&](int row) HWY_ATTR {
                    return hn::Mul(hn::LoadU(d, stored + (3 * corner + row) * n + i), scale);
                };
                triangles.corner[corner] = {coordinate(0), coordinate(1), coordinate(2)};
            }
            store(d, Support<true>(across(d), triangles), start, i);
        }
        return start;
    }

    /// Calls look(place) for every register that holds a near pair, until it returns false.
    template <class Look>
    HWY_INLINE void visitPlaces(const Look& look) {
        constexpr std::uint32_t kLanes = std::uint32_t(hn::MaxLanes(PairTag()));
        int block = 0;
        for (std::uint32_t i = 0; i < part_->triangleCount; i += kBlock) {
            for (std::uint32_t j = 0; j < environment_->triangleCount; j += kBlock) {
                const std::uint32_t near = near_[block++];
                for (std::uint32_t first = 0; near >> first != 0; first += kLanes) {
                    const std::uint32_t lanes = (near >> first) & ((1u << kLanes) - 1);
                    if (lanes != 0 && !look(RegisterPlace{i, j, first, lanes})) return;
                }
            }
        }
    }

    /// The pairs of a register that goes to the kernel at once.
    HWY_INLINE TrianglePair<hn::Vec<PairTag>> loadPairs(const RegisterPlace& place) {
        kernelPairs_ += std::uint64_t(hwy::PopCount(std::uint64_t(place.near)));
        kernelLanes_ += hn::MaxLanes(PairTag());
        Triangles<hn::Vec<PairTag>> a, b;
        load(place.i, place.j, place.first, a, b);
        return {a, b};
    }

    /// Appends a register's near pairs to those that wait.
    HWY_INLINE void append(const RegisterPlace& place, WaitingPairs& waiting) const {
        const PairTag d;
        const hn::RebindToSigned<PairTag> di;
        const int at = waiting.count;
#if HWY_TARGET == HWY_SCALAR
        const auto ofPart = std::int32_t(place.first / kBlock),
                   ofEnvironment = std::int32_t(place.first % kBlock);
        const auto gathered = [&](const float* row, std::int32_t triangle) {
            return hn::Set(d, row[triangle]);
        };
        const auto partTriangles = hn::Set(di, ofPart), environmentTriangles = hn::Set(di, ofEnvironment);
#else
        const std::uint8_t near[8] = {std::uint8_t(place.near), std::uint8_t(place.near >> 8)};
        const auto pairs = hn::CompressBits(hn::Iota(di, std::int32_t(place.first)), near);
        const auto inBlock = hn::Set(di, kBlock - 1);
        const auto partTriangles = hn::And(hn::ShiftRight<2>(pairs), inBlock);
        const auto environmentTriangles = hn::And(pairs, inBlock);
        const auto ofPart = hn::IndicesFromVec(d, partTriangles);
        const auto ofEnvironment = hn::IndicesFromVec(d, environmentTriangles);
        const auto gathered = [&](const float* row, const auto& triangles) HWY_ATTR {
            return hn::TableLookupLanes(hn::LoadDup128(d, row), triangles);
        };
#endif
        const float* environmentRow = environment_->offsets + place.j;
        const auto scale = hn::Set(d, query_->environmentLeafToQuery);
        for (int k = 0; k < 9; ++k, environmentRow += environment_->triangleCount) {
            hn::StoreU(gathered(moved_[place.i / kBlock][k].of, ofPart), d, waiting.partCorners[k] + at);
            hn::StoreU(hn::Mul(gathered(environmentRow, ofEnvironment), scale), d,
                       waiting.environmentCorners[k] + at);
        }
        hn::StoreU(hn::Set(d, roundingError_), d, waiting.roundingErrors + at);
        hn::StoreU(hn::Set(d, volumesBound_), d, waiting.knownBounds + at);
        const auto storeTriangles = [&](auto inBlocks, std::uint32_t first, LeafReference leaf,
                                        WaitingPairs::Triangle& to) HWY_ATTR {
            hn::StoreU(hn::Add(inBlocks, hn::Set(di, std::int32_t(first))), di, to.number + at);
            hn::StoreU(hn::Set(di, std::int32_t(leaf)), di, to.leaf + at);
        };
        storeTriangles(partTriangles, place.i, part_->at, waiting.partTriangles);
        storeTriangles(environmentTriangles, place.j, environment_->at, waiting.environmentTriangles);
        waiting.count += int(hwy::PopCount(std::uint64_t(place.near)));
    }

    /// Loads the register that begins with pair `first` of the blocks that begin with the part's triangle i
    /// and the environment's triangle j.
    template <class V = hn::Vec<PairTag>>
    HWY_INLINE void load(std::uint32_t i, std::uint32_t j, size_t first, Triangles<V>& a,
                         Triangles<V>& b) const {
        const PairTag d;
        const std::uint32_t n = environment_->triangleCount;
        const float* stored = environment_->offsets + j;
        const auto scale = hn::Set(d, query_->environmentLeafToQuery);
        for (int corner = 0; corner < 3; ++corner) {
            const auto part = [&](int row) HWY_ATTR {
                return SpreadPart(d, moved_[i / kBlock][3 * corner + row], first);
            };
            const auto environment = [&](int row) HWY_ATTR {
                return hn::Mul(SpreadEnvironment(d, stored + (3 * corner + row) * n, first), scale);
            };
            a.corner[corner] = {part(0), part(1), part(2)};
            b.corner[corner] = {environment(0), environment(1), environment(2)};
        }
    }

    /// The pairs of two blocks that a cheap bound does not prove to be dropFrom apart, as bits.
    template <class Move>
    HWY_INLINE std::uint32_t cull(std::uint32_t i, std::uint32_t j, const BlockStart& partStart,
                                  float dropFrom, const Move& move) const {
        const PairTag d;
        using V = hn::Vec<PairTag>;
        const std::uint32_t present = presentPairs(part_->triangleCount - i, environment_->triangleCount - j);
        const BlockStart start = startOfEnvironment(j);
        const Lanes3<V> leaves = across(d);
        const V leavesSquared = Dot(leaves, leaves);
        const V needSquared = hn::Set(d, NeedSquared((dropFrom + roundingError_) *
                                                     (1 + kNeedSumRoundoffs * float(kUnitRoundoffFloat))));
        std::uint32_t near = 0;
        for (size_t first = 0; first < kBlockPairs; first += hn::Lanes(d)) {
            V width =
                hn::Sub(SpreadEnvironment(d, start.along.of, first), SpreadPart(d, partStart.along, first));
            if constexpr (!Move::kIsNone) width = hn::Sub(width, hn::Set(d, move.nearingLeaves));
            const std::uint32_t lanes = (present >> first) & ((1u << hn::Lanes(d)) - 1);
            if ((lanes & ~MaskBits(d, ProvesApart(d, width, leavesSquared, needSquared))) == 0) continue;
            const auto difference = [&](int row) HWY_ATTR {
                return hn::Sub(SpreadEnvironment(d, start.corner[row].of, first),
                               SpreadPart(d, partStart.corner[row], first));
            };
            Triangles<V> a, b;
            load(i, j, first, a, b);
            const auto proved = WalkProvesApart<kWalkSteps>(
                d, a, b, {difference(0), difference(1), difference(2)}, needSquared, move);
            near |= (lanes & ~MaskBits(d, proved)) << first;
        }
        return near;
    }

    /// The pairs that exist, as bits: blocks may hold fewer than 4 triangles.
    static HWY_INLINE std::uint32_t presentPairs(std::uint32_t partLeft, std::uint32_t environmentLeft) {
        const auto firstBits = [](std::uint32_t n) { return (1u << n) - 1; };
        return (firstBits(environmentLeft < kBlock ? environmentLeft : kBlock) * 0x1111) &
               firstBits(kBlock * (partLeft < kBlock ? partLeft : kBlock));
    }

    BlockRow moved_[kMostBlocks][9];
    std::uint32_t near_[kMostBlocks * kMostBlocks];
    const PairQuery* query_;
    const Leaf* part_;
    const Leaf* environment_;
    float offset_[3];
    float roundingError_;
    float volumesBound_;
    std::uint64_t kernelPairs_ = 0;
    std::uint64_t kernelLanes_ = 0;
};

}  // namespace HWY_NAMESPACE
}  // namespace clearway
HWY_AFTER_NAMESPACE();

#endif
