#include "planning/improve/part_moves.h"

#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>

#include <cmath>
#include <typeinfo>

#include "clearway/errors.h"
#include "planning/space/ompl_states.h"

namespace clearway::planning {

namespace {

PartState partState(bool isPlanar, const ob::State* state) {
    return isPlanar ? partStateOfSe2(state) : partStateOfSe3(state);
}

Vector3 rotationVector(const Eigen::Quaterniond& rotation) {
    const Eigen::AngleAxisd turn(rotation.w() < 0 ? Eigen::Quaterniond(-rotation.coeffs()) : rotation);
    return turn.angle() * turn.axis();
}

Eigen::Quaterniond quaternionOf(const Vector3& rotationVector) {
    const double angle = rotationVector.norm();
    if (angle == 0) return Eigen::Quaterniond::Identity();
    return Eigen::Quaterniond(Eigen::AngleAxisd(angle, rotationVector / angle));
}

}  // namespace

PartMoves::PartMoves(const ob::StateSpace& space, const Model& part)
    : isPlanar_(typeid(space) == typeid(ob::SE2StateSpace)),
      centreOnPart_(part.box().center()),
      radius_(0.5 * part.box().diagonal().norm()) {
    if (!isPlanar_ && !isOmplSe3(space)) {
        throw ArgumentError("the space is " + space.getName() + ", expected OMPL's SE(3) or SE(2)");
    }
}

Pose PartMoves::pose(const ob::State* state) const {
    const PartState part = partState(isPlanar_, state);
    return {part.rotation.normalized().toRotationMatrix(), part.position};
}

Twist PartMoves::between(const ob::State* from, const ob::State* to) const {
    const PartState a = partState(isPlanar_, from), b = partState(isPlanar_, to);
    const Eigen::Quaterniond qa = a.rotation.normalized(), qb = b.rotation.normalized();
    Twist twist;
    twist.head<3>() = (b.position + qb * centreOnPart_) - (a.position + qa * centreOnPart_);
    twist.tail<3>() = lever() * rotationVector(qb * qa.conjugate());
    return twist;
}

void PartMoves::move(const ob::State* from, const Twist& twist, ob::State* to) const {
    const PartState before = partState(isPlanar_, from);
    const Eigen::Quaterniond rotation = before.rotation.normalized();
    const Eigen::Quaterniond turned = (quaternionOf(twist.tail<3>() / lever()) * rotation).normalized();
    const Vector3 position =
        before.position + rotation * centreOnPart_ + twist.head<3>() - turned * centreOnPart_;
    write(position, turned, to);
}

void PartMoves::setPose(const Pose& X_environmentPart, ob::State* to) const {
    write(X_environmentPart.translation, toQuaternion(X_environmentPart), to);
}

void PartMoves::write(const Vector3& position, const Eigen::Quaterniond& rotation, ob::State* to) const {
    if (isPlanar_) {
        auto* se2 = to->as<ob::SE2StateSpace::StateType>();
        se2->setXY(position.x(), position.y());
        const double yaw = std::remainder(2 * std::atan2(rotation.z(), rotation.w()), 2 * M_PI);
        se2->setYaw(yaw < M_PI ? yaw : -M_PI);  // OMPL's angles end before pi
    } else {
        auto* se3 = to->as<ob::SE3StateSpace::StateType>();
        se3->setXYZ(position.x(), position.y(), position.z());
        auto& q = se3->rotation();
        q.x = rotation.x();
        q.y = rotation.y();
        q.z = rotation.z();
        q.w = rotation.w();
    }
}

Twist PartMoves::along(const Vector3& direction, const Vector3& point, const Pose& X_environmentPart) const {
    Twist row;
    row.head<3>() = direction;
    row.tail<3>() = (point - centre(X_environmentPart)).cross(direction) / lever();
    if (isPlanar_) row(2) = row(3) = row(4) = 0;
    return row;
}

}  // namespace clearway::planning
