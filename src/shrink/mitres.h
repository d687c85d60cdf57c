// Where the vertices of a surface move when its faces move inwards.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "clearway/mesh.h"
#include "shrink/oriented_surface.h"

namespace clearway {

/// How far faces move, and how far their corners may; mesh units.
struct MitreDepths {
    double face;  ///< every face moves so far inwards
    double most;  ///< corners should end no deeper below the surface
};

/// A place to which a vertex moves. A vertex has several where an edge between its faces is sharp and concave.
struct MovedVertex {
    std::uint32_t vertex;
    Vector3 move;
};

/// A triangle between moved vertices: a face itself, a piece of a strip along a concave edge, or of the patch at a vertex with
/// several places. side: one of the surface, of the face or the edge it belongs to, or at the vertex.
struct MovedTriangle {
    std::array<std::uint32_t, 3> places;
    std::uint32_t side;
};

/// The surface, moved: closed as the surface is, whatever the places are.
struct MovedSurface {
    std::vector<MovedVertex> places;
    std::vector<MovedTriangle> triangles;
};

/// Moves all faces inwards and joins them by mitres. A place is the nearest one to its vertex at which all faces that meet there have
/// moved by depths.face: closed forms, one vertex at a time. Edges whose mitre would be deeper than depths.most are bevelled.
MovedSurface mitred(const OrientedSurface& surface, const MitreDepths& depths);

/// The shortest move that leads at least `depth` behind all planes through the origin with these unit normals; none when it is
/// more than a hundred times as long, as between the two sides of a sheet.
std::optional<Vector3> shortestMove(const std::vector<Vector3>& normals, double depth);

}  // namespace clearway
