// Tells when a part lies inside an obstacle that only counts as a surface.
#pragma once

#include <string>
#include <vector>

#include "clearway/mesh.h"
#include "clearway/types.h"

namespace clearway::cli {

/// Says that a piece of the part, at a pose, is inside a closed component of one of the worlds, and which key makes
/// that a collision; otherwise empty. The part must touch nothing at the pose.
std::string enclosureNote(const Mesh& part, const std::vector<Mesh>& worlds, const Pose& X_environmentPart);

}  // namespace clearway::cli
