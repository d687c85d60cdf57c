// Triangulates polygons inside their outline, by ear clipping in the polygon's best plane. Orientations are decided exactly.
// Source: Meisters, Polygons have ears, Amer. Math. Monthly 82 (1975); the plane is Newell's.
#pragma once

#include <cstdint>
#include <vector>

#include "clearway/mesh.h"

namespace clearway {

/// The outcome of triangulating a polygon.
struct PolygonShape {
    bool isFilled = true;  ///< false: it crosses itself, and no triangle was made
    double height = 0;     ///< the largest distance of a corner from the polygon's plane; mesh units
    double size = 0;       ///< the diagonal of the corners' box
};

/// Appends the count - 2 triangles of a polygon with at least three corners. Corners on a line, equal corners and outlines that touch
/// themselves (as around a hole) make triangles without area, which the mesh keeps. A polygon whose corners lie on a line is a fan.
PolygonShape triangulate(const std::vector<Vector3>& vertices, const std::uint32_t* corners,
                         std::size_t count, std::vector<TriangleIndices>& triangles);

}  // namespace clearway
