// The surface between the vertices of tetrahedra that are inside a body and those that are not ("marching
// tetrahedra"; Doi and Koide, IEICE Trans. E74-D, 1991). It is closed: a tetrahedron with smaller neighbours is cut along
// their edges too.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "clearway/mesh.h"
#include "swept/tetrahedra.h"

namespace clearway {

/// The point at a share of the way from one vertex to the other. It keeps a small distance from both, so that points on
/// different edges differ.
Vector3 pointOnEdge(const Vector3& from, const Vector3& to, double share);

/// The point between an inner vertex, with a height of at least 0, and an outer one with a height below 0,
/// at which the height is 0 if it changes evenly. It lies as pointOnEdge() says.
Vector3 cutPoint(const Vector3& inner, double innerHeight, const Vector3& outer, double outerHeight);

struct CutSurface {
    Mesh mesh;                              ///< its triangles face outwards
    std::vector<std::uint32_t> tetrahedra;  ///< the one in which each triangle lies
};

/// An edge that the surface crosses.
struct CutEdge {
    std::uint32_t inner, outer;  ///< vertices
};

/// The closed polygons in which the surface leaves a tetrahedron. They turn counter-clockwise, seen from outside the
/// body. At most one has corners if the tetrahedron's edges are whole.
std::vector<std::vector<CutEdge>> outlinesIn(const Tetrahedra& tetrahedra, const Tetrahedron& tetrahedron,
                                             const std::vector<double>& heights);

/// The triangles that fill a polygon with so many corners, turned as it is. Corner number `corners` is a point amid it.
/// isPlain: only outline points of a tetrahedron with whole edges; else a diagonal might lie in one of its faces, where a
/// neighbour's surface may have it too.
std::vector<std::array<int, 3>> filling(int corners, bool isPlain);

/// The point at which the surface crosses an edge.
using PointOnEdge = std::function<Vector3(const CutEdge& edge)>;

/// heights: one for each vertex, at least 0 inside. pointOn: that of cutPoint() where none is given.
CutSurface cutSurface(const Tetrahedra& tetrahedra, const std::vector<double>& heights,
                      const PointOnEdge& pointOn = {});

}  // namespace clearway
