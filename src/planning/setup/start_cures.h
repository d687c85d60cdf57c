// How to write a problem whose part touches obstacles at its start.
#pragma once

#include <string>

#include "clearway/planning/validity_checker.h"
#include "clearway/problem.h"

namespace clearway::planning {

/// The keys of [clearway] that let the problem begin at its start, which is in collision; begins with "; ".
std::string startCures(const Problem& problem, const ValidityChecker& checker,
                       const ompl::base::State* start);

}  // namespace clearway::planning
