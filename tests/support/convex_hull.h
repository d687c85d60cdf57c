// The convex hull of points, built by adding one point at a time: fast enough for a few thousand points.
#pragma once

#include <vector>

#include "clearway/mesh.h"

namespace clearway::testing {

/// The hull as a closed mesh, counter-clockwise seen from outside. Points within 1e-9 of the cloud's size of
/// a face count as inside, so the volume exceeds the hull's only by rounding. Throws std::invalid_argument if
/// all points lie in a plane.
Mesh convexHull(const std::vector<Vector3>& points);

/// The volume of a closed, counter-clockwise mesh, or of one run of its triangles.
double signedVolume(const Mesh& mesh);
double signedVolume(const Mesh& mesh, const Component& component);

}  // namespace clearway::testing
