// Start and goal must be valid before any planner is asked.
#pragma once

#include <string>

#include "clearway/planning/validity_checker.h"

namespace clearway::planning {

/// Throws std::invalid_argument, naming the two closest meshes and triangles, unless the state is valid.
/// what: "start". returns the clearance.
double requireValid(const ValidityChecker& checker, const ompl::base::State* state, const std::string& what);

}  // namespace clearway::planning
