// Meshes as Parasol Planning Library (PPL) places them.
#pragma once

#include <string>

#include "clearway/mesh.h"

namespace clearway::testing {

/// Loads a .g or .obj file as PPL does: shifted by minus the mean of the file's vertices, as
/// its origin says. The vertices of an .obj
/// file must be distinct. Throws as readByuMesh and loadMesh do.
Mesh loadPplMesh(const std::string& file);

}  // namespace clearway::testing
