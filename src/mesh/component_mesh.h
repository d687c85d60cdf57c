// Some of a mesh's components as a mesh of their own.
#pragma once

#include <cstddef>
#include <vector>

#include "clearway/mesh.h"

namespace clearway {

/// With the vertices that their triangles use. The components keep their names, and the origin is the mesh's.
Mesh meshOfComponents(const Mesh& mesh, const std::vector<std::size_t>& components);

/// At least one: a mesh without components is one nameless component.
std::vector<Component> componentsOf(const Mesh& mesh);

}  // namespace clearway
