// Follows a path by OMPL's interpolation and asks the oracle.
#pragma once

#include <vector>

#include "clearway/problem.h"
#include "support/oracle.h"

namespace clearway::testing {

/// `states` poses, evenly spread over the path's motions by length (translation plus a tenth of the scene's
/// size times OMPL's rotation distance), ends included.
std::vector<Pose> posesAlong(const std::vector<PartState>& path, Space space, double sceneSize, int states);

/// The least distance by the oracle at this many poses along the path.
double leastDistance(const MeshOracle& oracle, const std::vector<PartState>& path, const Problem& problem,
                     int states);

/// The number of these poses that collide. The oracle decides exactly, and faster than it measures distances.
int collisionsAlong(const MeshOracle& oracle, const std::vector<PartState>& path, const Problem& problem,
                    int states);

}  // namespace clearway::testing
