// Makes a mesh fit for a tree: checked, equal vertices welded, exact duplicates dropped, degenerate ones
// kept.
#pragma once

#include <cstdint>
#include <vector>

#include "clearway/build_report.h"
#include "clearway/mesh.h"

namespace clearway {

struct CleanMesh {
    std::vector<Vector3> vertices;  ///< each used, no two equal; -0.0 counts as 0.0
    std::vector<TriangleIndices> triangles;
    std::vector<std::uint32_t> triangleIds;  ///< of each its position in the mesh given; a duplicate's first
    CleanReport report;
};

/// A zero-area triangle is a segment or a point in exact arithmetic of its doubles; those kept are counted.
/// Throws std::invalid_argument as Model::build says.
CleanMesh clean(const Mesh& mesh);

}  // namespace clearway
