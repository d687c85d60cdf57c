// The directions in which a model is spread.
#pragma once

#include "clearway/model.h"

#pragma GCC visibility push(default)  // clearway::planning calls it

namespace clearway {

/// The eigenvectors of the covariance of the triangles' corners, by rising spread; mesh coordinates.
Matrix3 principalAxesOf(const Model& model);

}  // namespace clearway

#pragma GCC visibility pop
