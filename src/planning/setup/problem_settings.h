// What a problem sets of OMPL's space and sampler, for all planners or for one.
#pragma once

#include <ompl/base/SpaceInformation.h>

#include <string>
#include <vector>

#include "clearway/problem.h"

namespace clearway::planning {

/// The problem as it is for one planner (OMPL's class name): its first choice of that planner may set the
/// sampler, the objective's threshold and other settings in its own way.
Problem problemFor(const std::string& planner, const Problem& problem);

/// Whether any planner of the problem may draw its states so.
bool mayUseSampler(const Problem& problem, const std::string& sampler);

/// Sets up the space information, with the problem's sampler and settings. Adds a warning for a setting that
/// neither the space nor the sampler has. Throws std::invalid_argument for an unknown sampler and for a value
/// that OMPL refuses.
void setUp(ompl::base::SpaceInformation& si, const Problem& problem, std::vector<std::string>& warnings);

}  // namespace clearway::planning
