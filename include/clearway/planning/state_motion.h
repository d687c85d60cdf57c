// How the part moves while OMPL interpolates between two states, with velocities.
#pragma once

#include <ompl/base/StateSpace.h>

#include <functional>

#include "clearway/model.h"
#include "clearway/sweep.h"

namespace clearway::planning {

/// Returns the pieces of the motion from one state to another: their poses are those of the states that the space
/// interpolates, but for rounding (2^-47 of the lengths involved). The states outlive the pieces, which one thread asks for.
/// It is called from several threads at once.
using StateMotion = std::function<MotionPieces(const ompl::base::State* from, const ompl::base::State* to)>;

/// The motions of OMPL's SE(3) and SE(2): straight, with a turn at a constant rate about an axis fixed in the part. Turns
/// that OMPL may leave out, below 2e-4 rad, are not trusted: they may happen or not. Throws std::invalid_argument that names
/// the space when it is another one, even one derived from these. Its pieces throw std::runtime_error when OMPL cannot
/// interpolate a state.
StateMotion stateMotion(const ompl::base::StateSpacePtr& space, const Model& part);

}  // namespace clearway::planning
