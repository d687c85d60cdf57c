// The surface between the vertices of tetrahedra that are inside a body and those that are not ("marching
// tetrahedra"; Doi and Koide, IEICE Trans. E74-D, 1991). Where the tetrahedra conform, it is closed.
#pragma once

#include <cstdint>
#include <vector>

#include "clearway/mesh.h"
#include "isosurface/tetrahedra.h"

namespace clearway {

/// The point between an inner vertex, with a height of at least 0, and an outer one with a height below 0,
/// at which the height is 0 if it changes evenly. It keeps a small distance from both, so that points on
/// different edges differ.
Vector3 cutPoint(const Vector3& inner, double innerHeight, const Vector3& outer, double outerHeight);

struct CutSurface {
    Mesh mesh;                              ///< its triangles face outwards
    std::vector<std::uint32_t> tetrahedra;  ///< the one in which each triangle lies
};

/// heights: one for each vertex, at least 0 inside.
CutSurface cutSurface(const Tetrahedra& tetrahedra, const std::vector<double>& heights);

}  // namespace clearway
