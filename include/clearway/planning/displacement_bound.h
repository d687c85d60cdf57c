// How far the points of the part move while OMPL interpolates between two states.
#pragma once

#include <ompl/base/StateSpace.h>

#include <functional>

#include "clearway/model.h"

#pragma GCC visibility push(default)

namespace clearway::planning {

/// Returns L for the motion from one state to another, in environment units: no point of the part moves
/// further than L |b - a| between interpolate(a) and interpolate(b), nor further than L between the poses of
/// the two states themselves. It is called from several threads at once. A result that is not finite means
/// that the motion has no bound.
using DisplacementBound = std::function<double(const ompl::base::State* from, const ompl::base::State* to)>;

/// Makes the bound for OMPL's SE(3) (straight translation, slerp about a fixed axis), Se3Space and SE(2), with any
/// subspace weights. The bound is NaN when a quaternion does not have unit length to 1e-9, because OMPL does
/// not interpolate such a state. partRadius: the largest distance of a vertex of the part from the origin of
/// its own coordinates (Model::radiusAboutOrigin). Throws ArgumentError that names the space when it
/// is another one, even one derived from these: it may interpolate differently, so that its bound must come from a
/// callback.
DisplacementBound displacementBound(const ompl::base::StateSpace& space, double partRadius);

/// Makes a tighter bound: a rotation moves the part by the part's radius about the axis of that rotation
/// (Model::radiusAboutAxis). Throws as the other overload does.
DisplacementBound displacementBound(const ompl::base::StateSpace& space, const Model& part);

}  // namespace clearway::planning

#pragma GCC visibility pop
