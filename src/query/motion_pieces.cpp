#include "query/motion_pieces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "clearway/errors.h"
#include "core/number.h"

namespace clearway {
namespace {

/// Rounding adds at most this much to a closing speed, in u32 of the field at the origin and of the turn times the reach of
/// the trees.
constexpr double kFieldRoundoffs = 64;
/// Composing the field in double, in u64 of the speed and of the turn times the largest coordinate.
constexpr double kFieldRoundoffsInDouble = 32;

/// Query units: squares of longer ways overflow float.
constexpr double kFurthest = 1e15;

/// In turns times reaches; a rigid motion's bow is at most half of one.
constexpr double kLongestBow = 1000;

/// perUnit: mesh units -> the tree's unit.
MovedField fieldIn(double perUnit, const Vector3& atOrigin, const Vector3& turn, double deviation,
                   double bow) {
    MovedField field{};
    field.deviation = nextFloatAbove(deviation * perUnit);
    field.bow = nextFloatAbove(bow * perUnit);
    for (int row = 0; row < 3; ++row) {
        field.atOrigin[row] = static_cast<float>(atOrigin[row] * perUnit);
        field.turn[row] = static_cast<float>(turn[row]);
    }
    return field;
}

}  // namespace

MovedField PreparedPiece::fieldAbout(const Vector3& point) const {
    const Vector3 arm = point - Vector3(query.t[0], query.t[1], query.t[2]);
    const Vector3 moved = (velocity + turn.cross(arm)) * query.perMeshUnit;
    MovedField field{};
    field.deviation = deviation;
    field.bow = bow;
    for (int row = 0; row < 3; ++row) {
        field.atOrigin[row] = static_cast<float>(moved[row]);
        field.turn[row] = static_cast<float>(turn[row]);
    }
    return field;
}

void PieceCache::begin(const FlatTree& part, const FlatTree& environment, const MotionPieces& motion) {
    part_ = &part;
    environment_ = &environment;
    motion_ = &motion;
    for (PreparedPiece& piece : pieces_) piece.key = 0;
}

void PieceCache::prepare(TimeInterval interval, PreparedPiece& piece) const {
    const MotionPiece given = (*motion_)(interval.from(), interval.to());
    if (!given.velocity.allFinite() || !given.angularVelocity.allFinite() || !(given.deviation >= 0) ||
        !std::isfinite(given.deviation) || !(given.deviationAcrossRotation >= 0) ||
        !std::isfinite(given.deviationAcrossRotation)) {
        throw ArgumentError(
            "a piece of a motion is not finite, expected finite velocities and deviations >= 0");
    }
    piece.key = 0;  // the slot stays empty if something throws
    piece.query = preparePairQuery(*part_, *environment_, given.middle);
    piece.counts = given.counts;
    piece.isForbidden = given.isForbidden;
    const PairQuery& query = piece.query;
    const double half = 0.5 * interval.width();
    piece.velocity = half * given.velocity;
    piece.turn = half * given.angularVelocity;

    const Matrix3 toPart = given.middle.rotation.transpose();
    const Vector3 turnInPart = toPart * piece.turn;
    const Vector3 inEnvironment =
        piece.velocity + piece.turn.cross(environment_->origin - given.middle.translation);
    const Vector3 inPart = toPart * piece.velocity + turnInPart.cross(part_->origin);

    const double perMeshUnit = query.perMeshUnit, turned = piece.turn.norm(),
                 reach = query.reach / perMeshUnit;
    const double furthest =
        (inEnvironment.norm() + inPart.norm() + turned * reach + given.deviation) * perMeshUnit;
    if (!(furthest < kFurthest)) {
        throw ArgumentError("a piece of a motion moves a point of the part by up to " +
                            shortNumber(furthest / perMeshUnit) + ", expected less than " +
                            shortNumber(kFurthest / perMeshUnit) + ", which is 1e15 times the meshes' unit");
    }
    const double rounding =
        kFieldRoundoffs * kUnitRoundoffFloat * (inEnvironment.norm() + inPart.norm() + 2 * turned * reach) +
        kFieldRoundoffsInDouble * kUnitRoundoffDouble *
            (piece.velocity.norm() + turned * query.largestCoordinate / perMeshUnit);
    // A bow that is long for its turn counts in all directions: float could lose products with the turn.
    const bool isUsable =
        given.deviationAcrossRotation <= kLongestBow * turned * turned * reach && turned > 0;
    const double bow = isUsable ? given.deviationAcrossRotation / turned : 0;
    const double deviation = given.deviation + rounding + (isUsable ? 0 : given.deviationAcrossRotation);
    piece.inEnvironment =
        fieldIn(perMeshUnit / query.environmentLeafToQuery, inEnvironment, piece.turn, deviation, bow);
    piece.inPart = fieldIn(perMeshUnit / query.partLeafToQuery, inPart, turnInPart, deviation, bow);
    piece.deviation = nextFloatAbove(deviation * perMeshUnit);
    piece.bow = nextFloatAbove(bow * perMeshUnit);
    piece.key = interval.key;
}

namespace {

/// Rounding of a gap between two triangles along a direction of unit length, in u64 M: corners 1.8 for the part, products
/// with the direction 5.2 for each triangle, their difference 1.8, the direction's length 3 of at most 3.5; at most 25.
constexpr double kGapRoundoffs = 32;

/// A pair of triangles that moves, in double. Query units, environment's frame.
class MovingPair {
  public:
    MovingPair(const PreparedPiece& piece, const TrianglesAt& triangles)
        : piece_(piece),
          a_(movedCorners(piece.query, triangles.part)),
          b_(fixedCorners(piece.query, triangles.environment)) {
        const PairQuery& query = piece.query;
        const Vector3 origin = Vector3(query.t[0], query.t[1], query.t[2]) * query.perMeshUnit;
        for (int k = 0; k < 3; ++k) {
            moves_[k] = piece.velocity * query.perMeshUnit + piece.turn.cross(a_.p[k] - origin);
        }
    }

    Vector3 meanMove() const { return moves_[0] + moves_[1] + moves_[2]; }
    Vector3 normalOfPart() const { return a_.normal(); }
    Vector3 normalOfEnvironment() const { return b_.normal(); }

    /// Raises the shares by what a direction of any length proves. known: a proved distance along it.
    void certifyAlong(const Vector3& direction, double known, double needed, MovedShares& shares) const {
        const double length = direction.norm();
        if (!(length > 1e-150) || !std::isfinite(length)) return;
        Vector3 n = direction / length;
        double above = kMost, below = kMost, highA = -kMost, highB = -kMost, up = -kMost, down = -kMost;
        for (int k = 0; k < 3; ++k) {
            const double a = n.dot(a_.p[k]), b = n.dot(b_.p[k]), move = n.dot(moves_[k]);
            above = std::min(above, b);
            below = std::min(below, a);
            highA = std::max(highA, a);
            highB = std::max(highB, b);
            up = std::max(up, move);
            down = std::max(down, -move);
        }
        above -= highA;
        below -= highB;
        if (below > above) std::swap(up, down);
        const double rounding = kGapRoundoffs * kUnitRoundoffDouble * piece_.query.largestCoordinate;
        const double excess = std::max(std::max(above, below) - rounding, known) - needed;
        if (!(excess > 0)) return;
        const double bowed = n.cross(piece_.turn).norm() * double(piece_.bow) + double(piece_.deviation);
        shares.after = std::max(shares.after, share(excess, up + bowed));
        shares.before = std::max(shares.before, share(excess, down + bowed));
    }

  private:
    static constexpr double kMost = std::numeric_limits<double>::max();
    static float share(double excess, double closing) {
        constexpr double kLargest = 4;  // more than a whole half piece
        return closing * kLargest < excess ? float(kLargest) : float(excess / closing) * (1 - 0x1p-22f);
    }

    const PreparedPiece& piece_;
    Corners a_, b_;
    Vector3 moves_[3];
};

}  // namespace

MovedShares sharesInDouble(const PreparedPiece& piece, const TrianglesAt& triangles, const ResolvedPair& pair,
                           double needed) {
    MovedShares shares;
    const MovingPair moving(piece, triangles);
    const Vector3 move = moving.meanMove(), apart = pair.apartAlong;
    moving.certifyAlong(apart, pair.lower, needed, shares);
    const double squared = move.squaredNorm();
    if (squared > 0) moving.certifyAlong(apart - apart.dot(move) / squared * move, 0, needed, shares);
    moving.certifyAlong(moving.normalOfPart(), 0, needed, shares);
    moving.certifyAlong(moving.normalOfEnvironment(), 0, needed, shares);
    return shares;
}

}  // namespace clearway
