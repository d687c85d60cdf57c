// The [planner] section: NAME = makes a planner, NAME.PARAMETER = VALUE sets a parameter of the last one of
// that name.
#pragma once

#include <string>
#include <vector>

#include "clearway/problem.h"
#include "problem/config_file.h"

namespace clearway {

/// The planners of the entries, in the file's order; entries of other sections are passed over. Adds a
/// warning for what has no effect. Throws std::invalid_argument, naming file and line, for a key that is
/// neither form. Keys are put in lower case, as OMPL.app does.
std::vector<PlannerChoice> plannerChoices(const std::string& file, const std::vector<ConfigEntry>& entries,
                                          std::vector<std::string>& warnings);

}  // namespace clearway
