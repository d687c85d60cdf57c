#include "clearway/planning/state_motion.h"

#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <typeinfo>
#include <utility>

#include "clearway/errors.h"
#include "clearway/planning/state_to_pose.h"
#include "planning/space/ompl_states.h"

namespace clearway::planning {
namespace {

namespace ob = ompl::base;

/// OMPL leaves a turn out when the product of the quaternions is within 1e-9 of 1, and their norms may be off 1 by as much:
/// at angles up to 1.6e-4 rad.
constexpr double kLeastTrustedTurn = 2e-4;

/// How far OMPL's rates are off constant ones, as a share: its slerp takes an acos of quaternions that have unit length only
/// to 1e-9.
constexpr double kRateError = 1e-7;

/// A motion with constant velocities, as OMPL interpolates it.
class SteadyMotion {
  public:
    SteadyMotion(ob::StateSpacePtr space, StateToPose pose, const ob::State* from, const ob::State* to)
        : space_(std::move(space)),
          pose_(std::move(pose)),
          from_(from),
          to_(to),
          scratch_(space_->allocState()) {}
    ~SteadyMotion() { space_->freeState(scratch_); }
    SteadyMotion(const SteadyMotion&) = delete;
    SteadyMotion& operator=(const SteadyMotion&) = delete;

    MotionPiece piece(double from, double to) const {
        const double half = 0.5 * (to - from);
        space_->interpolate(from_, to_, from + half, scratch_);
        MotionPiece piece;
        piece.middle = pose_(scratch_);
        piece.velocity = velocity;
        piece.angularVelocity = turn;
        // Points on a circle are off its tangent by radius angle^2 / 2.
        const double angle = half * turn.norm();
        piece.deviationAcrossTurn = 0.5 * angle * angle * radius;
        piece.deviation = half * doubtfulSpeed;
        return piece;
    }

    Vector3 velocity = Vector3::Zero(), turn = Vector3::Zero();
    double radius = 0;         ///< of the part about the axis
    double endJump = 0;        ///< see PartMotion
    double doubtfulSpeed = 0;  ///< by which points may move in any direction

  private:
    const ob::StateSpacePtr space_;
    const StateToPose pose_;
    const ob::State *from_, *to_;
    ob::State* scratch_;
};

/// Bounds how far the part reaches from an axis.
class PartReach {
  public:
    explicit PartReach(const Model& part) : aboutOrigin(part.radiusAboutOrigin()) {
        for (int corner = 0; corner < 8; ++corner) {
            corners_[corner] = part.box().corner(static_cast<Box::CornerType>(corner));
        }
    }

    /// About an axis of unit length through the origin: at most, the box's. Model::radiusAboutAxis is tighter, but takes
    /// longer than a short motion.
    double about(const Vector3& axis) const {
        double squared = 0;
        for (const Vector3& corner : corners_) squared = std::max(squared, axis.cross(corner).squaredNorm());
        return std::min(aboutOrigin, std::sqrt(squared) * (1 + 1e-12));
    }

    double aboutOrigin;

  private:
    std::array<Vector3, 8> corners_;
};

double addRateError(SteadyMotion& motion, double aboutOrigin) {
    const double speed = kRateError * (motion.velocity.norm() + motion.turn.norm() * aboutOrigin);
    motion.doubtfulSpeed += speed;
    return speed;
}

/// Whether OMPL interpolates from a to -b. Between orientations half a turn apart only OMPL's own rounding tells.
bool turnsTheOtherWay(const Eigen::Vector4d& a, const Eigen::Vector4d& b, const SteadyMotion& motion) {
    constexpr double kSure = 1e-9;
    const double product = a.dot(b);
    if (std::abs(product) > kSure) return product < 0;
    const Eigen::Quaterniond middle(motion.piece(0, 1).middle.rotation);
    return std::abs(middle.coeffs().dot(a + b)) < std::abs(middle.coeffs().dot(a - b));
}

/// Sets the motion and returns its length.
double setSe3(const ob::State* from, const ob::State* to, const PartReach& reach, SteadyMotion& motion) {
    const PartState a = partStateOfSe3(from), b = partStateOfSe3(to);
    if (!canBeInterpolated(a) || !canBeInterpolated(b)) return std::numeric_limits<double>::quiet_NaN();
    const Eigen::Vector4d qa = a.rotation.coeffs().normalized();
    Eigen::Vector4d qb = b.rotation.coeffs().normalized();
    if (turnsTheOtherWay(qa, qb, motion)) qb = -qb;
    const double angle = 4 * std::atan2((qa - qb).norm(), (qa + qb).norm());
    motion.velocity = b.position - a.position;
    if (!(angle > kLeastTrustedTurn)) {
        motion.doubtfulSpeed = motion.endJump = angle * reach.aboutOrigin;
        const double rounding = addRateError(motion, reach.aboutOrigin);
        return motion.velocity.norm() + angle * reach.aboutOrigin + rounding;
    }
    // The axis of the rotation qb * conjugate(qa), in the environment's frame. Turned by conjugate(qa), it is the axis in
    // the part's frame.
    const Vector3 crossed = qb.head<3>().cross(qa.head<3>());
    const Vector3 difference = qa.w() * qb.head<3>() - qb.w() * qa.head<3>();
    const Vector3 axis = (difference - crossed).normalized();
    motion.turn = angle * axis;
    motion.radius = reach.about((difference + crossed).normalized());
    const double along = motion.velocity.dot(axis), across = (motion.velocity - along * axis).norm();
    return std::hypot(along, across + angle * motion.radius) + addRateError(motion, reach.aboutOrigin);
}

double setSe2(const ob::State* from, const ob::State* to, const PartReach& reach, double radius,
              SteadyMotion& motion) {
    const auto* a = from->as<ob::SE2StateSpace::StateType>();
    const auto* b = to->as<ob::SE2StateSpace::StateType>();
    motion.velocity = {b->getX() - a->getX(), b->getY() - a->getY(), 0};
    double turn = b->getYaw() - a->getYaw();  // OMPL turns the shorter way
    if (turn > M_PI) turn -= 2 * M_PI;
    if (turn < -M_PI) turn += 2 * M_PI;
    motion.turn = {0, 0, turn};
    motion.radius = radius;
    return motion.velocity.norm() + std::abs(turn) * radius + addRateError(motion, reach.aboutOrigin);
}

template <class Set>
StateMotion steadyMotion(const ob::StateSpacePtr& space, const Set& set) {
    return
        [space, pose = stateToPose(*space), set](const ob::State* from, const ob::State* to) -> PartMotion {
            const auto motion = std::make_shared<SteadyMotion>(space, pose, from, to);
            const double length = set(from, to, *motion);
            return {[motion](double begin, double end) { return motion->piece(begin, end); }, length,
                    motion->endJump};
        };
}

}  // namespace

StateMotion stateMotion(const ob::StateSpacePtr& space, const Model& part) {
    const PartReach reach(part);
    const ob::StateSpace& omplSpace = *space;
    if (isOmplSe3(omplSpace)) {
        return steadyMotion(space, [reach](const ob::State* from, const ob::State* to, SteadyMotion& motion) {
            return setSe3(from, to, reach, motion);
        });
    }
    if (typeid(omplSpace) == typeid(ob::SE2StateSpace)) {
        return steadyMotion(space, [reach, radius = part.radiusAboutAxis(Vector3::UnitZ())](
                                       const ob::State* from, const ob::State* to, SteadyMotion& motion) {
            return setSe2(from, to, reach, radius, motion);
        });
    }
    throw ArgumentError("state space '" + space->getName() +
                        "' is neither OMPL's SE(3) nor its SE(2), expected a motion of its own");
}

}  // namespace clearway::planning
