// The [planner] section: NAME = makes a planner, NAME.PARAMETER = VALUE sets a parameter of the last one of
// that name, problem.KEY = VALUE a setting of the problem for the planner before it, or the first one.
#pragma once

#include <string>
#include <vector>

#include "clearway/problem.h"
#include "problem/config_file.h"

namespace clearway {

/// Whether a key of [problem] is one that OMPL.app hands on to OMPL's space or sampler.
bool isSetting(const std::string& key);

/// Fills problem.planners, in the file's order; entries of other sections are passed over. Adds a warning for
/// what has no effect. Throws std::invalid_argument, naming file and line, for a key that is none of these
/// forms. Keys are put in lower case, as OMPL.app does.
void readPlanners(const std::string& file, const std::vector<ConfigEntry>& entries, Problem& problem);

}  // namespace clearway
