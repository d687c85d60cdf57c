// The components of a mesh: as a list, as meshes of their own, and their names.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "clearway/mesh.h"

namespace clearway {

/// The mesh's components, at least one: a mesh without components is one nameless component.
std::vector<Component> componentsOf(const Mesh& mesh);

/// The given components as one mesh with only the vertices they use. The components keep their names; the
/// origin is copied from the mesh.
Mesh meshOfComponents(const Mesh& mesh, const std::vector<std::size_t>& components);

/// The largest deflection of the mesh's components, in mesh coordinates.
double deflectionOf(const Mesh& mesh);

/// "node/mesh", or only one of the names when both are equal or one is missing. Names that an importer made
/// up ("<STL_BINARY>", "$ColladaAutoName$_0", "defaultobject") count as missing.
std::string componentName(const std::string& node, const std::string& mesh);

/// Gives nameless components the fallback, then appends #2, #3, ... to every name that an earlier component
/// has.
void makeNamesDistinct(std::vector<Component>& components, const std::string& fallback);

}  // namespace clearway
