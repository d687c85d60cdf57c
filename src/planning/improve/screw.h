// Screw motions of the part: a turn about an axis in space, and a translation along it.
#pragma once

#include "clearway/scene_clearance.h"

namespace clearway::planning {

/// A twist of space at a constant rate: a point x moves at velocity + angular x x. Environment's frame.
struct Screw {
    Vector3 angular;   ///< radians per unit of time
    Vector3 velocity;  ///< of the point of the part at the environment's origin

    Screw operator*(double factor) const { return {factor * angular, factor * velocity}; }
};

/// The pose of a part that moves along the screw for a time.
Pose movedAlong(const Screw& screw, const Pose& X_environmentPart, double time);

/// The screw that takes one pose to another in a unit of time, by the shorter rotation.
Screw screwBetween(const Pose& from, const Pose& to);

/// The motion of a part along the screw for a unit of time.
PartMotion motionAlong(const Screw& screw, const Pose& from, const Model& part);

}  // namespace clearway::planning
