// How much of a level below the surface is round: the level follows a concave edge as a part of a cylinder.
#pragma once

#include "shrink/surface_depth.h"

namespace clearway {

/// The sum over all concave edges of length times turn (radians). Leaves out edges whose level at this depth a plane
/// follows to within the tolerance.
double concaveLength(const SurfaceDepth& surface, double depth, double tolerance);

}  // namespace clearway
