// A mesh taken apart for writing: one list of float vertices and triangles for each component.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "clearway/mesh.h"

namespace clearway {

struct SavePart {
    std::string name;
    std::vector<std::array<float, 3>> vertices;
    std::vector<TriangleIndices> triangles;  ///< into vertices, in the mesh's order
};

/// The components that hold triangles, in order; each with the vertices it uses, in order of first use,
/// rounded to float. Throws std::invalid_argument when the mesh is not sound (see requireSoundMesh) or a
/// coordinate is beyond float's range.
std::vector<SavePart> savePartsOf(const Mesh& mesh, const std::string& namelessName);

}  // namespace clearway
