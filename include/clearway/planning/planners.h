// OMPL's geometric planners by name, and one of ours, with parameters as text.
#pragma once

#include <ompl/base/Planner.h>
#include <ompl/base/SpaceInformation.h>

#include <string>
#include <vector>

#include "clearway/problem.h"

namespace clearway::planning {

/// OMPL's class names ("RRTConnect", "BITstar", ...), in alphabetical order, and RisingFloor, which plans for
/// paths of more and more least clearance. That one needs a clearway::planning::ValidityChecker, and an
/// environment with no lesser reach than that objective asks for.
std::vector<std::string> plannerNames();

/// OMPL's class name for a planner written in any case, or for one of OMPL.app's short names ("kpiece",
/// "bkpiece", "lbkpiece", "spars2", "aps"). Throws std::invalid_argument that lists the known planners.
std::string plannerClassName(const std::string& name);

/// False for planners that use several threads, their own clock or values never set: the same seed and number
/// of iterations may give another path. name: as plannerClassName takes it.
bool isRepeatable(const std::string& name);

/// Throws like plannerClassName.
ompl::base::PlannerPtr makePlanner(const ompl::base::SpaceInformationPtr& si, const std::string& name);

/// True when the planner declares such a parameter.
bool hasParameter(const ompl::base::Planner& planner, const std::string& parameter);

/// Sets one of the parameters that the planner declares. Throws std::invalid_argument when there is none of
/// that name (lists them), or the value is not of its type or below the least one that OMPL suggests.
void setParameter(ompl::base::Planner& planner, const std::string& parameter, const std::string& value);

}  // namespace clearway::planning
