#include "clearway/planning/displacement_bound.h"

#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>

#include <cmath>
#include <limits>
#include <string>
#include <typeinfo>

#include "clearway/errors.h"
#include "core/number.h"
#include "planning/space/ompl_states.h"

namespace clearway::planning {
namespace {

namespace ob = ompl::base;

/// OMPL's slerp takes its own acos of quaternions that have unit length only to 1e-9. The factor covers that
/// and our own rounding.
constexpr double kUp = 1 + 1e-7;

/// Sine of half the angle. Below it the axis is not known well enough to split the translation along it.
constexpr double kLeastAxisSine = 1e-6;

/// Rounding of the axis, in radians times that sine: a few 2^-53.
constexpr double kAxisRounding = 1e-14;

/// radiusAbout(axis): how far the part reaches from an axis of any length in the part's frame. radius: the
/// part's radius about its origin.
template <class RadiusAbout>
double se3Bound(const ob::State* from, const ob::State* to, double radius, const RadiusAbout& radiusAbout) {
    const PartState a = partStateOfSe3(from), b = partStateOfSe3(to);
    if (!canBeInterpolated(a) || !canBeInterpolated(b)) return std::numeric_limits<double>::quiet_NaN();
    const Eigen::Vector4d qa = a.rotation.coeffs().normalized();
    Eigen::Vector4d qb = b.rotation.coeffs().normalized();
    if (qa.dot(qb) < 0) qb = -qb;
    const double angle = 4 * std::atan2((qa - qb).norm(), (qa + qb).norm());
    const Vector3 d = b.position - a.position;

    // The axis of the rotation qb * conjugate(qa), in the environment's frame. Turned by conjugate(qa), it is
    // the axis in the part's frame.
    const Vector3 crossed = qb.head<3>().cross(qa.head<3>());
    const Vector3 difference = qa.w() * qb.head<3>() - qb.w() * qa.head<3>();
    const Vector3 axis = difference - crossed, axisInPart = difference + crossed;
    const double sine = axis.norm();
    if (!(sine > kLeastAxisSine)) return (d.norm() + angle * radius) * kUp;
    const double along = d.dot(axis) / sine;
    const double across = (d - along / sine * axis).norm();
    const double reach = radiusAbout(axisInPart) + kAxisRounding / sine * radius;
    return std::hypot(along, across + angle * reach) * kUp;
}

/// radius: the part's radius about z through its origin.
double se2Bound(const ob::State* from, const ob::State* to, double radius) {
    const auto* a = from->as<ob::SE2StateSpace::StateType>();
    const auto* b = to->as<ob::SE2StateSpace::StateType>();
    const double difference = std::abs(b->getYaw() - a->getYaw());  // OMPL turns the shorter way
    const double turn = difference <= M_PI ? difference : std::abs(2 * M_PI - difference);
    return (std::hypot(b->getX() - a->getX(), b->getY() - a->getY()) + turn * radius) * kUp;
}

template <class RadiusAbout>
DisplacementBound makeBound(const ob::StateSpace& space, double radius, const RadiusAbout& radiusAbout) {
    if (isOmplSe3(space)) {
        return [=](const ob::State* a, const ob::State* b) { return se3Bound(a, b, radius, radiusAbout); };
    }
    if (typeid(space) == typeid(ob::SE2StateSpace)) {
        return [aboutZ = radiusAbout(Vector3::UnitZ())](const ob::State* a, const ob::State* b) {
            return se2Bound(a, b, aboutZ);
        };
    }
    throw ArgumentError("state space '" + space.getName() +
                        "' is neither OMPL's SE(3) nor its SE(2), expected a displacement bound of its own");
}

}  // namespace

DisplacementBound displacementBound(const ob::StateSpace& space, double partRadius) {
    requireNotNegative("partRadius", partRadius);
    return makeBound(space, partRadius, [partRadius](const Vector3&) { return partRadius; });
}

DisplacementBound displacementBound(const ob::StateSpace& space, const Model& part) {
    return makeBound(space, part.radiusAboutOrigin(),
                     [part](const Vector3& axis) { return part.radiusAboutAxis(axis); });
}

}  // namespace clearway::planning
