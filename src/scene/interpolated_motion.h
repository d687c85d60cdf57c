// The motions of OMPL's SE(3) and SE(2): straight, with a turn at a constant rate about an axis fixed in the part. OMPL's
// rounding is allowed for.
#pragma once

#include <array>
#include <functional>

#include "clearway/problem.h"
#include "clearway/scene.h"
#include "clearway/sweep.h"

// clearway::planning uses it too, from another shared library.
#pragma GCC visibility push(default)

namespace clearway {

/// Bounds how far the part reaches from an axis.
class PartExtent {
  public:
    explicit PartExtent(const Model& part);

    /// About an axis of unit length through the origin: at most, the box's. Model::radiusAboutAxis is tighter, but takes
    /// longer than a short motion.
    double about(const Vector3& axis) const;

    double aboutOrigin;

  private:
    std::array<Vector3, 8> corners_;
};

/// A motion with constant velocities, from time 0 to 1. Where the part is, the interpolation says. Lengths in environment units.
struct SteadyMotion {
    Vector3 velocity = Vector3::Zero();         ///< of the origin of the part's coordinates
    Vector3 angularVelocity = Vector3::Zero();  ///< radians; environment's frame
    double radius = 0;                          ///< of the part about the axis
    double doubtfulSpeed = 0;                   ///< by which points may move in any direction
    double length = 0;   ///< see PartMotion; NaN for states that OMPL does not interpolate
    double endJump = 0;  ///< see PartMotion

    /// The piece from halfTime before the middle pose to halfTime after it.
    MotionPiece around(const Pose& middle, double halfTime) const;
};

/// Whether OMPL interpolates the state: a quaternion's norm may be off 1 by 1e-9. Beyond it a state satisfies no bounds, and
/// OMPL asserts.
bool canBeInterpolated(const PartState& state);

/// The motion in SE(3). Turns of up to 2e-4 rad, which OMPL may leave out, are not trusted: they may happen or not.
/// turnsTheOtherWay: OMPL's slerp goes to the negative of the second quaternion.
SteadyMotion se3Motion(const PartExtent& part, const PartState& from, const PartState& to,
                       bool turnsTheOtherWay);

/// The motion in SE(2). States are (x, y, yaw); radius: the part's about z through its origin.
SteadyMotion se2Motion(const PartExtent& part, double radius, const Vector3& from, const Vector3& to);

/// How far an axis of any length, in the part's frame, has the part from it at most.
using RadiusAbout = std::function<double(const Vector3& axis)>;

/// No point of the part moves further during the motion. This is tighter than SteadyMotion::length, but takes longer than a
/// short motion. NaN for states that OMPL does not interpolate. radius: the part's about its origin.
double se3Displacement(const PartState& from, const PartState& to, double radius,
                       const RadiusAbout& radiusAbout);

/// The same bound in SE(2). States are (x, y, yaw); radius: the part's about z through its origin.
double se2Displacement(const Vector3& from, const Vector3& to, double radius);

double diagonalOf(const Box& box);  ///< 0 for an empty box

/// By default a motion is undecided where it cannot be certified in stretches that move the part by more than this: 1e-5 of
/// the diagonal of the part's box, or of the environment's box when the part is a point.
double defaultLeastInterval(const Scene& scene);

}  // namespace clearway

#pragma GCC visibility pop
