// The closed surfaces that an obstacle's skin consists of.
#pragma once

#include <cstdint>
#include <vector>

#include "clearway/mesh.h"

namespace clearway {

/// Triangles that hang together by edges: of each its shell, numbered from 0 in the order of their first
/// triangles. Vertices must be welded.
struct Shells {
    std::vector<std::uint32_t> ofTriangle;
    std::uint32_t count = 0;
};
Shells findShells(const std::vector<TriangleIndices>& triangles);

/// Six times the volume each shell encloses, positive when its triangles turn counter-clockwise seen from
/// outside; to rounding, relative to the shell's own box.
std::vector<double> signedVolumes(const std::vector<Vector3>& vertices,
                                  const std::vector<TriangleIndices>& triangles, const Shells& shells);

}  // namespace clearway
