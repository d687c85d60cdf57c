// The [planner] section. NAME = adds a planner. NAME.PARAMETER = VALUE sets a parameter of the last planner
// of that name. problem.KEY = VALUE sets a setting of the problem for the planner before it, or for the first
// planner.
#pragma once

#include <string>
#include <vector>

#include "clearway/problem.h"
#include "problem/config.h"

namespace clearway {

/// Whether OMPL.app passes this key of [problem] on to OMPL's space or sampler.
bool isSetting(const std::string& key);

/// Fills problem.planning.planners in the file's order and skips entries of other sections. Keys are put into lower
/// case, as in OMPL.app. Adds a warning for each entry without effect. Throws ArgumentError, naming
/// file and line, for a key of another form and, where the file has a section [clearway] (isClearways), for an unknown
/// setting.
void readPlanners(const std::string& file, const std::vector<ConfigEntry>& entries, bool isClearways,
                  Problem& problem);

}  // namespace clearway
