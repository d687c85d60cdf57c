// How the part moves while OMPL interpolates between two states, with velocities.
#pragma once

#include <ompl/base/StateSpace.h>

#include <functional>

#include "clearway/model.h"
#include "clearway/scene_clearance.h"

#pragma GCC visibility push(default)

namespace clearway::planning {

/// Returns the motion between two states, which outlive it; one thread uses the motion. It is called from several threads at
/// once.
using StateMotion = std::function<PartMotion(const ompl::base::State* from, const ompl::base::State* to)>;

/// The motions of OMPL's SE(3) and SE(2): straight, with a rotation at a constant rate about an axis fixed in the
/// part. Rotations below 2e-4 rad, which OMPL may leave out, are not trusted: they may happen or not. Throws
/// ArgumentError that names the space when it is another one, even one derived from these.
StateMotion stateMotion(const ompl::base::StateSpacePtr& space, const Model& part);

}  // namespace clearway::planning

#pragma GCC visibility pop
