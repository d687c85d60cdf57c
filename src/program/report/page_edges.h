// The edges that a drawing of a surface needs, because faces alone do not show where they end.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "clearway/mesh.h"

namespace clearway::report {

/// A triangle and the component that it belongs to.
using OwnedTriangle = std::pair<std::uint32_t, TriangleIndices>;

struct OwnedEdge {
    std::uint32_t owner = 0;  ///< component
    std::array<std::uint32_t, 2> ends{};
};

/// The edges at which the planes of two triangles meet at more than 30 degrees, the borders of open sheets, and the
/// edges of more than two triangles, in the order of their components. Vertices must be welded. Triangles of
/// different components share no edge. Triangles with two equal corners are left out.
std::vector<OwnedEdge> featureEdges(const std::vector<Vector3>& vertices,
                                    const std::vector<OwnedTriangle>& triangles);

/// Drops all but the longest edges, and keeps the order.
void keepLongest(std::vector<OwnedEdge>& edges, const std::vector<Vector3>& vertices, std::size_t most);

}  // namespace clearway::report
