// Tells what `clearway info` finds in a mesh.
#pragma once

#include <optional>
#include <string>

#include "clearway/model.h"

namespace clearway::cli {

/// Tells the file and the conversions on reading, the box, whether the surface is closed, the findings of cleaning, and the
/// tree. name: of the mesh among the facts. reading: how the file was read, in words. model: of the mesh; where it was built with a
/// range, a row counts the triangles beyond it.
void describeMesh(const char* name, const Mesh& mesh, const std::string& reading, const Model& model,
                  const std::optional<QueryRange>& range = std::nullopt);

}  // namespace clearway::cli
