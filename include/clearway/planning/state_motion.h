// How the part moves while OMPL interpolates between two states, with velocities.
#pragma once

#include <ompl/base/StateSpace.h>

#include <functional>
#include <limits>

#include "clearway/model.h"
#include "clearway/sweep.h"

namespace clearway::planning {

/// The motion of the part from one state to another.
struct PartMotion {
    /// The poses are those of the states that the space interpolates, but for rounding: 2^-47 of the lengths involved.
    MotionPieces pieces;
    /// No point of the part moves further than length |b - a| between the times a and b. Not finite when the states make
    /// no motion.
    double length = 0;
    /// No point of the part is further than this, and rounding, from where the interpolation ends when it is at the second
    /// state. 0: the interpolation ends there.
    double endJump = std::numeric_limits<double>::infinity();
};

/// Returns the motion between two states, which outlive it; one thread uses the motion. It is called from several threads at
/// once.
using StateMotion = std::function<PartMotion(const ompl::base::State* from, const ompl::base::State* to)>;

/// The motions of OMPL's SE(3) and SE(2): straight, with a turn at a constant rate about an axis fixed in the part. Turns
/// that OMPL may leave out, below 2e-4 rad, are not trusted: they may happen or not. Throws std::invalid_argument that names
/// the space when it is another one, even one derived from these.
StateMotion stateMotion(const ompl::base::StateSpacePtr& space, const Model& part);

}  // namespace clearway::planning
