// Prepares a mesh for a tree: checks it, welds equal vertices, drops exact duplicates of triangles and counts
// degenerate triangles.
#pragma once

#include <cstdint>
#include <vector>

#include "clearway/build_options.h"
#include "clearway/mesh.h"
#include "clearway/types.h"

namespace clearway {

struct CleanMesh {
    std::vector<Vector3> vertices;  ///< all used, no two equal; -0.0 counts as 0.0
    std::vector<TriangleIndices> triangles;
    std::vector<std::uint32_t>
        triangleIds;  ///< each one's position in the given mesh; of duplicates the first
    CleanReport report;
};

/// Cleans the mesh. Triangles of zero area are kept as the segment or point they are, and counted. Throws
/// ArgumentError as requireSoundMesh does.
CleanMesh clean(const Mesh& mesh);

/// Cleans each component as if it were a mesh of its own, but for the order of its vertices. The reports count only duplicates.
/// Throws ArgumentError as requireSoundMesh does.
std::vector<CleanMesh> cleanComponents(const Mesh& mesh);

/// Whether the three finite points lie on one line or coincide, decided in exact arithmetic.
bool isDegenerate(const Vector3& a, const Vector3& b, const Vector3& c);

}  // namespace clearway
