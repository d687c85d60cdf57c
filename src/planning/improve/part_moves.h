// Small moves of the part as vectors of six lengths.
#pragma once

#include <ompl/base/StateSpace.h>

#include "clearway/model.h"

namespace clearway::planning {

/// A straight move of the centre of the part's box, then a turn about that centre: environment axes, environment
/// units. The last three entries are the turn's rotation vector (radians) times PartMoves::lever().
using Twist = Eigen::Matrix<double, 6, 1>;

/// Twists between the states of OMPL's SE(3), Se3Space or SE(2). In SE(2) a twist has no z, and turns about z only.
class PartMoves {
  public:
    /// The space must outlive this object. Throws ArgumentError that names the space when it is another one.
    PartMoves(const ompl::base::StateSpace& space, const Model& part);

    /// Half the diagonal of the part's box.
    double radius() const { return radius_; }
    /// Turns count as the way of a point that is half the radius from the axis.
    double lever() const { return 0.5 * radius_; }

    /// The twist that moves the part from one state to another by the shorter turn.
    Twist between(const ompl::base::State* from, const ompl::base::State* to) const;

    /// Moves `from` by a twist. The two states may be the same.
    void move(const ompl::base::State* from, const Twist& twist, ompl::base::State* to) const;

    Pose pose(const ompl::base::State* state) const;
    /// Sets a state to a pose; in SE(2) to its position and its turn about z.
    void setPose(const Pose& X_environmentPart, ompl::base::State* to) const;
    /// Whether the space is SE(2).
    bool isPlanar() const { return isPlanar_; }
    Vector3 centre(const Pose& X_environmentPart) const { return X_environmentPart * centreOnPart_; }

    /// The twist whose product with another twist is how far that one moves a point of the part along a direction, to
    /// first order. point: environment coordinates.
    Twist along(const Vector3& direction, const Vector3& point, const Pose& X_environmentPart) const;

  private:
    void write(const Vector3& position, const Eigen::Quaterniond& rotation, ompl::base::State* to) const;

    bool isPlanar_;
    Vector3 centreOnPart_;
    double radius_;
};

}  // namespace clearway::planning
