// The fit of least area over several frames: those of the vertices' and of the area's covariance, the
// parent's, the model's own axes and, for small nodes, those along edges of the largest triangles.
#pragma once

#include "build/fit/fit_input.h"

namespace clearway {

/// A fit, as fits.h says.
Rss fitLeastOfFrames(const FitInput& node, FitScratch& scratch);

}  // namespace clearway
