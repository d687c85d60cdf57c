// The surface in a part at one depth below its own.
#pragma once

#include "clearway/mesh.h"
#include "clearway/shrink.h"
#include "shrink/surface_depth.h"

namespace clearway {

/// A closed surface that lies in the part, everywhere as deep as the options say. Empty where nothing is so deep.
/// Throws ArgumentError when the tolerance takes too many points, or it is unclear what is inside the part.
Mesh cutAtDepth(const SurfaceDepth& surface, const ShrinkOptions& options);

}  // namespace clearway
