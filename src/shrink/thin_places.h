// Moves that end between two sheets of a surface.
#pragma once

#include <vector>

#include "shrink/mitres.h"
#include "shrink/nearest_triangle.h"

namespace clearway {

/// How deep below the surface a place ends; negative outside.
double depthOf(const Vector3& place, NearestTriangle& nearest, const OrientedSurface& nearestSurface);

/// Shortens the moves that come too near to another sheet of the surface: each of the two stays before their middle, at the centre of a
/// ball between them. Returns which places were moved less.
std::vector<bool> keepBeforeMiddles(const OrientedSurface& surface, NearestTriangle& nearest,
                                    const OrientedSurface& nearestSurface, double depth, MovedSurface& moved);

}  // namespace clearway
