// How triangles hang together: whether a surface is closed, and the connected shells it consists of.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "clearway/mesh.h"

namespace clearway {

/// Counts of edges by how the triangles meet there. A surface is closed when along each edge as many triangles
/// run one way as the other way; then it winds equally often around all points of a space that it bounds.
struct EdgeReport {
    std::size_t closedEdges = 0;  ///< two triangles, opposite directions
    std::size_t touchingEdges =
        0;                         ///< four triangles or more, half of them in each direction: surfaces touch
    std::size_t openEdges = 0;     ///< one triangle: a border
    std::size_t twistedEdges = 0;  ///< two triangles, same direction: one of them is turned over
    std::size_t overfullEdges = 0;  ///< three triangles or more, not half of them in each direction

    bool isClosed() const { return openEdges == 0 && twistedEdges == 0 && overfullEdges == 0; }
};

/// The sets of triangles that are connected by edges, numbered from 0 in the order of their first triangles.
struct Shells {
    std::vector<std::uint32_t> ofTriangle;  ///< the shell of each triangle
    std::uint32_t count = 0;
};

struct Topology {
    EdgeReport edges;
    Shells shells;
};

/// Counts the edges and finds the shells of triangles with welded vertices (equal points have equal indices). The counts leave out
/// triangles that name a vertex twice: such a triangle has collapsed to an edge, which its two neighbours then share.
Topology findTopology(const std::vector<TriangleIndices>& triangles);

inline EdgeReport checkEdges(const std::vector<TriangleIndices>& triangles) {
    return findTopology(triangles).edges;
}

inline Shells findShells(const std::vector<TriangleIndices>& triangles) {
    return findTopology(triangles).shells;
}

/// Six times the volume that each shell encloses, positive when its triangles turn counter-clockwise seen
/// from outside. The rounding is relative to the shell's own box.
std::vector<double> signedVolumes(const std::vector<Vector3>& vertices,
                                  const std::vector<TriangleIndices>& triangles, const Shells& shells);

}  // namespace clearway
