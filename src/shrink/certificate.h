// How far a moved surface is from where it was.
#pragma once

#include "shrink/mitres.h"
#include "shrink/nearest_triangle.h"
#include "shrink/oriented_surface.h"

namespace clearway {

/// Shortens moves until no point that the surface sweeps is further than `most` from where it was; a surface whose places all move by
/// at most that is always certified. The surface moves piece by piece: the prism between a triangle of the moved surface and the
/// corners that it came from, in three tetrahedra that its neighbours share. A tetrahedron is near enough when one triangle of the
/// surface is within `most` of all its corners, because the distance to a triangle is convex; else it is cut. Returns which
/// places were moved less. nearest: of the surface, or of one that covers the same points.
std::vector<bool> certifyMoves(const OrientedSurface& surface, NearestTriangle& nearest,
                               const OrientedSurface& nearestSurface, double most, MovedSurface& moved);

}  // namespace clearway
