// Tells files of CAD programs that hold surfaces, by their contents.
#pragma once

#include <istream>
#include <string>

namespace clearway {

/// The format of a file that holds curved surfaces, or a CAD program's own model, in place of triangles: "a STEP
/// file". Empty for all others; these are left to the reader of meshes. IFC files, which assimp reads, are written as
/// STEP is and count among the others. stream: at the file's beginning, is moved.
std::string surfaceFormat(std::istream& stream);

}  // namespace clearway
