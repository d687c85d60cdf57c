// The pieces of a motion made ready for a sweep: the query at each piece's middle and how far points of the part move from
// there. A sweep meets few pieces, again and again.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "clearway/sweep.h"
#include "kernels/moved_field.h"
#include "query/pair_query.h"
#include "query/refine.h"

namespace clearway {

/// A dyadic interval of time: its position in a binary tree, 1 for [0, 1], and 2 k and 2 k + 1 for the halves of k.
struct TimeInterval {
    std::uint64_t key = 1;

    int depth() const { return 63 - __builtin_clzll(key); }
    double width() const { return 1 / double(std::uint64_t(1) << depth()); }
    double from() const { return double(key - (std::uint64_t(1) << depth())) * width(); }
    double middle() const { return from() + 0.5 * width(); }
    double to() const { return from() + width(); }
    TimeInterval firstHalf() const { return {2 * key}; }
    TimeInterval lastHalf() const { return {2 * key + 1}; }
    bool canBeHalved() const { return depth() < kDeepest; }

    static constexpr int kDeepest = 50;  ///< the times of deeper intervals would be rounded
};

struct PreparedPiece {
    std::uint64_t key = 0;  ///< of the interval; 0: none
    PairQuery query;
    MovedField inPart, inEnvironment;
    Vector3 velocity, turn;  ///< in half the piece; environment's frame, mesh units
    float deviation, bow;    ///< as in MovedField, query units
    MotionPiece::Counts counts;
    bool isForbidden;

    /// The field about a point of the environment's frame, in that frame and query units.
    MovedField fieldAbout(const Vector3& point) const;
};

/// Prepares pieces and keeps the last ones.
class PieceCache {
  public:
    PieceCache() : pieces_(kPieces) {}

    /// Forgets the pieces of the last motion.
    void begin(const FlatTree& part, const FlatTree& environment, const MotionPieces& motion);

    const PreparedPiece& at(TimeInterval interval) {
        PreparedPiece& piece = pieces_[placeOf(interval.key)];
        if (piece.key != interval.key) prepare(interval, piece);
        return piece;
    }

  private:
    static constexpr std::size_t kPieces = 64;  ///< short motions have fewer
    static std::size_t placeOf(std::uint64_t key) {
        static_assert(kPieces == 1 << 6);
        return (key * 0x9E3779B97F4A7C15ull) >> (64 - 6);
    }
    void prepare(TimeInterval interval, PreparedPiece& piece) const;

    const FlatTree* part_ = nullptr;
    const FlatTree* environment_ = nullptr;
    const MotionPieces* motion_ = nullptr;
    std::vector<PreparedPiece> pieces_;
};

/// The shares of the half pieces after and before the middle that are certified; 0 for none.
struct MovedShares {
    float after = 0, before = 0;
};

/// Certifies a pair of triangles in double: along the direction that proves its distance, that direction turned square to
/// the pair's velocity, and both normals. needed: what the pair must stay farther apart than, query units.
MovedShares sharesInDouble(const PreparedPiece& piece, const TrianglesAt& triangles, const ResolvedPair& pair,
                           double needed);

}  // namespace clearway
