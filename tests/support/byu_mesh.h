// Meshes in the BYU movie format (.g), as the benchmarks of Parasol Lab have them; assimp does not read it.
#pragma once

#include <string>

#include "clearway/mesh.h"

namespace clearway::testing {

/// Reads the polygons of a .g file and cuts each into a fan of triangles around its first corner. The file has
/// four counts (parts, vertices, polygons, polygon corners), the first and last polygon of each part, the
/// vertices' coordinates, and the corners of each polygon, counted from 1; the last corner of a polygon is
/// negative. Each part becomes a component.
///
/// Throws std::runtime_error when the file cannot be read. Throws std::invalid_argument, naming the file, the
/// value and what was expected, when the file is not of this form or has no triangle.
Mesh readByuMesh(const std::string& file);

}  // namespace clearway::testing
