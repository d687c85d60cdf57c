// What of a part is missing after shrinking.
#pragma once

#include <string>
#include <vector>

#include "clearway/mesh.h"
#include "shrink/surface_depth.h"

namespace clearway {

/// One line for each component of the part of which the shrunk mesh has nothing, fewer or more pieces, or nothing
/// within three depths of some point. depth: how deep the shrunk mesh lies below the part's surface.
std::vector<std::string> findLeftOut(const SurfaceDepth& surface, const Mesh& shrunk, double depth);

}  // namespace clearway
