// What a mesh must be before anything is built from it: indices in range, finite vertices, components in
// order.
#pragma once

#include <cstddef>
#include <string>

#include "clearway/mesh.h"

namespace clearway {

/// "triangle 17 of component 'bracket' in 'engine.stl'", with the parts that are known.
std::string nameOfTriangle(const Mesh& mesh, std::size_t triangle);

/// Throws std::invalid_argument, naming the thing, its value and what was expected, when the mesh has no
/// triangle, its components are not consecutive runs that cover the triangles in order, or a triangle refers
/// to a vertex that is not there or not finite (the first such triangle is named).
void requireSoundMesh(const Mesh& mesh);

}  // namespace clearway
