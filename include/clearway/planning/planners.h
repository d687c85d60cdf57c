// OMPL's geometric planners and clearway's: made by name, set by text, run side by side.
#pragma once

#include <ompl/base/Planner.h>
#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/base/SpaceInformation.h>

#include <functional>
#include <string>
#include <vector>

#include "clearway/problem.h"

#pragma GCC visibility push(default)

namespace clearway::planning {

/// The names of all planners: OMPL's class names ("RRTConnect", "BITstar", ...), and clearway's own, in
/// alphabetical order: SlidingRRTConnect (see its header); PlannerTeam, which runs RRTConnect with restarts and two
/// SlidingRRTConnect, side by side or by turns, until one finds a path; and RisingFloor, which plans for paths of more and
/// more least clearance. The three need a clearway::planning::ValidityChecker.
/// RisingFloor also needs an environment whose range covers the clearances of max_min_clearance.
std::vector<std::string> plannerNames();

/// OMPL's class name for a planner written in any case, or for one of OMPL.app's short names ("kpiece",
/// "bkpiece", "lbkpiece", "spars2", "aps"). Throws ArgumentError that lists the known planners.
std::string plannerClassName(const std::string& name);

/// Whether the same seed and number of iterations give the same path. False for planners that use several
/// threads, their own clock or values that were never set. name: as plannerClassName takes it.
bool isRepeatable(const std::string& name);

/// Makes a planner, not yet set up. Where pSBL's sampler finds no valid state near another one, it takes that one again: OMPL's own pSBL
/// comes to a standstill there. Throws as plannerClassName does.
ompl::base::PlannerPtr makePlanner(const ompl::base::SpaceInformationPtr& si, const std::string& name);

/// True when the planner declares such a parameter.
bool hasParameter(const ompl::base::Planner& planner, const std::string& parameter);

/// Sets one of the parameters that the planner declares. Throws ArgumentError when the planner has no
/// parameter of that name (and lists its parameters), or the value is not of the parameter's type or below
/// the least value that OMPL suggests.
void setParameter(ompl::base::Planner& planner, const std::string& parameter, const std::string& value);

/// Runs planners side by side, the first one in the calling thread and each other one in a thread of its own,
/// and returns when all have ended. onFound, which must not be empty, is called by each planner that ends
/// with an exact solution, in that planner's thread; make isSpent true there when the first solution is to
/// end the others. Returns the status of the first planner. Throws what a planner throws, OmplError if
/// that is an exception of OMPL's, and ArgumentError without a planner.
ompl::base::PlannerStatus solveSideBySide(const std::vector<ompl::base::PlannerPtr>& planners,
                                          const ompl::base::PlannerTerminationCondition& isSpent,
                                          const std::function<void()>& onFound);

}  // namespace clearway::planning

#pragma GCC visibility pop
