#include "query/motion_pieces.h"

#include <cmath>
#include <stdexcept>

namespace clearway {
namespace {

/// What rounding may add to a closing speed, in u32 of the field at the origin and of the turn times the reach of the trees.
constexpr double kFieldRoundoffs = 64;
/// Composing the field in double, in u64 of the speed and of the turn times the largest coordinate.
constexpr double kFieldRoundoffsInDouble = 32;

/// perUnit: mesh units -> the tree's unit.
MovedField fieldIn(double perUnit, const Vector3& atOrigin, const Vector3& turn, double deviation) {
    MovedField field{};
    field.deviation = nextFloatAbove(deviation * perUnit);
    for (int row = 0; row < 3; ++row) {
        field.atOrigin[row] = static_cast<float>(atOrigin[row] * perUnit);
        field.turn[row] = static_cast<float>(turn[row]);
    }
    return field;
}

}  // namespace

void PieceCache::begin(const FlatTree& part, const FlatTree& environment, const MotionPieces& motion) {
    part_ = &part;
    environment_ = &environment;
    motion_ = &motion;
    for (PreparedPiece& piece : pieces_) piece.key = 0;
}

void PieceCache::prepare(TimeInterval interval, PreparedPiece& piece) const {
    const MotionPiece given = (*motion_)(interval.from(), interval.to());
    if (!given.velocity.allFinite() || !given.angularVelocity.allFinite() || !(given.deviation >= 0) ||
        !std::isfinite(given.deviation)) {
        throw std::invalid_argument("a piece of a motion is not finite, expected finite velocities and a deviation >= 0");
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

    const double toUnit = query.perMeshUnit, turned = piece.turn.norm();
    const double rounding =
        kFieldRoundoffs * kUnitRoundoffFloat * (inEnvironment.norm() + inPart.norm() + 2 * turned * query.reach / toUnit) +
        kFieldRoundoffsInDouble * kUnitRoundoffDouble *
            (piece.velocity.norm() + turned * query.largestCoordinate / toUnit);
    const double deviation = given.deviation + rounding;
    piece.inEnvironment = fieldIn(toUnit / query.environmentLeafToQuery, inEnvironment, piece.turn, deviation);
    piece.inPart = fieldIn(toUnit / query.partLeafToQuery, inPart, turnInPart, deviation);
    piece.deviation = nextFloatAbove(deviation * toUnit);
    piece.key = interval.key;
}

}  // namespace clearway
