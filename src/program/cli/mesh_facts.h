// Tells what `clearway info` finds in a mesh.
#pragma once

#include <optional>
#include <string>

#include "clearway/model.h"

namespace clearway::cli {

/// Tells the file and the conversions on reading, the box, whether the surface is closed, the findings of cleaning, and the
/// tree, and returns the model. name: of the mesh among the facts. reading: how the file was read, in words. With a range, the tree
/// leaves out the triangles beyond it and a row counts them.
Model describeMesh(const char* name, const Mesh& mesh, const std::string& reading,
                   const BuildOptions& options, const std::optional<QueryRange>& range = std::nullopt);

}  // namespace clearway::cli
