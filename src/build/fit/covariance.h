// PQP's fit: the frame of the corners' covariance. Source: Larsen, Gottschalk, Lin, Manocha, Fast Proximity
// Queries with Swept Sphere Volumes, TR99-018, 1999.
#pragma once

#include "build/fit/fit_input.h"

namespace clearway {

/// A fit, as fits.h says. A vertex weighs as much as the node has triangles about it.
Rss fitByCovariance(const FitInput& node, FitScratch& scratch);

}  // namespace clearway
