// The convex hull of points, one point added at a time: enough for the volume of a few thousand.
#pragma once

#include <vector>

#include "clearway/mesh.h"

namespace clearway::testing {

/// A closed mesh, counter-clockwise seen from outside. Points within 1e-9 of the cloud's size of a face count
/// as inside, so its volume is never more than the hull's by more than rounding. Throws std::invalid_argument
/// when all points lie in a plane.
Mesh convexHull(const std::vector<Vector3>& points);

/// Of a closed, counter-clockwise mesh, or of one run of its triangles.
double signedVolume(const Mesh& mesh);
double signedVolume(const Mesh& mesh, const Component& component);

}  // namespace clearway::testing
