// Refuses mesh files that cannot be read and meshes that nothing can be built from.
#pragma once

#include <cstddef>
#include <string>

#include "clearway/mesh.h"

namespace clearway {

/// Throws std::runtime_error with one line: the file, the reason and what was expected. The reason may be a
/// reader's own words, with several lines and a full stop.
[[noreturn]] void refuseMeshFile(const std::string& file, std::string reason);

/// Refuses a file that is missing, a folder, unreadable or empty, a CAD file that holds surfaces, a PLY file that ends
/// within its header, and an OFF file whose header states more items than the file can hold.
void requireReadableMeshFile(const std::string& file);

/// "triangle 17 of component 'bracket' in 'engine.stl'", as far as component and file are known.
std::string nameOfTriangle(const Mesh& mesh, std::size_t triangle);

/// Throws std::invalid_argument when the mesh has no triangle, its components are not consecutive runs that
/// cover the triangles in order, or a triangle refers to a vertex that does not exist or is not finite (the
/// first such triangle is named).
void requireSoundMesh(const Mesh& mesh);

}  // namespace clearway
