// Which obstacles a problem's part touches at its start.
#pragma once

#include <string>
#include <vector>

#include "clearway/problem.h"

// clearway::planning uses it too, from another shared library.
#pragma GCC visibility push(default)

namespace clearway {

/// Names of the obstacles that are no farther from the part than their margins at problem.start. Leaves out those that
/// contact.start names, and those with an overlap.
std::vector<std::string> touchedAtStart(const Problem& problem, const Mesh& part,
                                        const ObstacleGroups& obstacles);

}  // namespace clearway

#pragma GCC visibility pop
