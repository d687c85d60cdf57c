// Goes along a path by OMPL's interpolation and asks the oracle.
#pragma once

#include <vector>

#include "clearway/problem.h"
#include "support/oracle.h"

namespace clearway::testing {

/// The least distance by the oracle at `states` states, evenly spread over the path's motions by their length
/// (translation plus the part's reach times the angle), ends included.
double leastDistance(const MeshOracle& oracle, const std::vector<PartState>& path, const Problem& problem,
                     int states);

}  // namespace clearway::testing
