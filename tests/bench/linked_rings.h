// Two linked rings of very many triangles: meshes as large as memory allows, whose trees no modeller's cut helps.
#pragma once

#include <cstddef>
#include <vector>

#include "clearway/mesh.h"
#include "clearway/types.h"

namespace clearway::testing {

/// A torus about the z axis whose pipe, of radius 25, runs along a circle of radius 100. Four times as many quads run around
/// the axis as around the pipe, each cut into two triangles. All coordinates are representable in float. triangles: reached as
/// nearly as whole numbers of quads allow; at least 72.
Mesh ring(std::size_t triangles);

/// Poses of a ring that is linked with an equal one, all around a closed smooth way, without contact. The rings are between 1 and
/// 10 apart or so, and the closest places run along both.
std::vector<Pose> linkedRingPoses(int count);

}  // namespace clearway::testing
