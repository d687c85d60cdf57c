// Says which bodies of a part are missing after shrinking.
#pragma once

#include <string>
#include <vector>

#include "clearway/mesh.h"
#include "shrink/surface_depth.h"

namespace clearway {

/// One line for each component of the part of whose bodies the shrunk mesh has nothing, or several pieces, and one
/// for each with a point that is more than 3.25 depths from the shrunk mesh. Points at more than three depths may be
/// named too. depth: how deep the shrunk mesh lies below the part's surface.
std::vector<std::string> findLeftOut(const SurfaceDepth& surface, const Mesh& shrunk, double depth);

}  // namespace clearway
