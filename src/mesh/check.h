// Refuses mesh files that cannot be read and meshes that nothing can be built from.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "clearway/mesh.h"

namespace clearway {

/// Begins the note about the transform of assimp's root node, into which its readers put their own conventions.
constexpr const char* kAssimpsTurn = "transform of the root node applied: ";

/// Begins the note about a COLLADA file's unit and up axis, which assimp puts into that transform, too.
constexpr const char* kAssimpsUnit = "unit and up axis that the file declares applied: ";

/// Throws FileError with one line: the file, the reason and what was expected. The reason may be a
/// reader's own words, with several lines and a full stop.
[[noreturn]] void refuseMeshFile(const std::string& file, std::string reason);

/// Refuses a file that is missing, a folder, unreadable or empty, and a CAD file that holds surfaces.
void requireReadableMeshFile(const std::string& file);

/// "triangle 17 of component 'bracket' in 'engine.stl'", as far as component and file are known.
std::string nameOfTriangle(const Mesh& mesh, std::size_t triangle);

/// Throws ArgumentError when the mesh's components are not consecutive runs that cover the triangles in order.
void requireComponents(const Mesh& mesh);

/// Throws ArgumentError when the mesh has no triangle, its components are not consecutive runs that
/// cover the triangles in order, or a triangle refers to a vertex that does not exist or is not finite (the
/// first such triangle is named).
void requireSoundMesh(const Mesh& mesh);

/// The same for a mesh that a file holds: throws FileError, "cannot read mesh 'FILE': ...".
void requireSoundMeshFile(const Mesh& mesh, const std::string& file);

/// MeshOrigin::warnings of a mesh that was read from one file.
std::vector<std::string> readingWarnings(const Mesh& mesh);

/// The map by which assimp turned a file although it is read as stored: "x' = x, y' = z, z' = -y"; empty when it turned nothing.
std::string turnedByAssimp(const MeshOrigin& origin);

}  // namespace clearway
