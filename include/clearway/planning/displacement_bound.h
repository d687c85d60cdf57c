// How far the points of the part move while OMPL interpolates between two states.
#pragma once

#include <ompl/base/StateSpace.h>

#include <functional>

#include "clearway/model.h"

namespace clearway::planning {

/// L for the motion from one state to another, in environment units: no point of the part moves further than
/// L |b - a| between interpolate(a) and interpolate(b), nor further than L between the poses of the two
/// states themselves. Called from several threads at once; a result that is not finite means that the motion
/// has no bound.
using DisplacementBound = std::function<double(const ompl::base::State* from, const ompl::base::State* to)>;

/// For OMPL's SE(3) (straight translation, slerp about a fixed axis) and SE(2), with any subspace weights.
/// NaN when a quaternion is not of unit length to 1e-9, which OMPL does not interpolate. partRadius: largest
/// distance of a vertex of the part from the origin of its own coordinates (Model::radiusAboutOrigin). Throws
/// std::invalid_argument that names the space when it is another one, even one derived from these: it may
/// interpolate in its own way, so its bound must come from a callback.
DisplacementBound displacementBound(const ompl::base::StateSpace& space, double partRadius);

/// The same, tightened: a rotation is taken to move the part by its radius about the axis that it turns about
/// (Model::radiusAboutAxis).
DisplacementBound displacementBound(const ompl::base::StateSpace& space, const Model& part);

}  // namespace clearway::planning
