// The closed surface of a part, as the triangles hang together.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "clearway/mesh.h"

namespace clearway {

using Corners3 = std::array<Vector3, 3>;

/// Welded triangles that face outwards, with the neighbour across each side. Side 3 t + k leads from corner k of triangle t to the
/// next one. Components keep vertices of their own, also where they touch.
struct OrientedSurface {
    std::vector<Vector3> vertices;
    std::vector<TriangleIndices> triangles;
    std::vector<std::uint32_t> given;   ///< each triangle's position in the part's mesh
    std::vector<std::uint32_t> across;  ///< for each side the same edge's side in the neighbour

    static std::uint32_t triangleOf(std::uint32_t side) { return side / 3; }
    static std::uint32_t nextSide(std::uint32_t side) { return side % 3 == 2 ? side - 2 : side + 1; }
    static std::uint32_t previousSide(std::uint32_t side) { return side % 3 == 0 ? side + 2 : side - 1; }

    std::uint32_t from(std::uint32_t side) const { return triangles[side / 3][side % 3]; }
    std::uint32_t to(std::uint32_t side) const { return from(nextSide(side)); }
    Corners3 corners(std::uint32_t triangle) const {
        const auto& [a, b, c] = triangles[triangle];
        return {vertices[a], vertices[b], vertices[c]};
    }

    /// Pairs the sides anew; call it after triangles changed. Where more than two triangles meet at an edge, those are
    /// neighbours that have the least material between them.
    void findNeighbours();
};

/// The same surface, with the corners of its faces cut off around vertices: new vertices stand on the edges of vertex v, reach[v] away
/// from it, if the edge is at least twice as long. reach[v] = 0: none.
OrientedSurface withCutCorners(const OrientedSurface& surface, const std::vector<double>& reach);

/// Throws ArgumentError, naming the component, if one encloses nothing (see Solid).
OrientedSurface orientedSurface(const Mesh& part);

}  // namespace clearway
