// What info says about one mesh.
#pragma once

#include <optional>
#include <string>

#include "clearway/model.h"

namespace clearway::cli {

/// Prints what was read and applied, the box, whether the surface is closed, what cleaning did and the tree
/// it builds. reading: how the file was read, in words. With a reach, also how many triangles are out of it;
/// the tree is built without them. Returns the model.
Model describeMesh(const Mesh& mesh, const std::string& reading, const BuildOptions& options,
                   const std::optional<Reach>& reach = std::nullopt);

}  // namespace clearway::cli
