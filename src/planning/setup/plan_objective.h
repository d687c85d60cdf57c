// What a problem's path is to be optimised for.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "planning/objectives/objectives.h"
#include "planning/setup/plan.h"

namespace clearway::planning {

/// The objective that the options ask for, else the problem. Nothing when the first path will do: where
/// neither asks for more than length, to no threshold, or the problem asks for one that is not known. Throws
/// std::invalid_argument when the options do.
std::optional<ObjectiveChoice> chooseObjective(const Problem& problem, const PlanOptions& options);

/// Whether the choice is one of clearance.
bool asksForClearance(const std::optional<ObjectiveChoice>& choice, const Model& part);

/// The objective with its threshold: the problem's, or such a clearance that no path can have more, given the
/// lesser one of start and goal. Throws as makeObjective does.
ompl::base::OptimizationObjectivePtr makePlanObjective(const ompl::base::SpaceInformationPtr& si,
                                                       const Scene& scene, const ObjectiveChoice& choice,
                                                       const std::optional<double>& threshold,
                                                       double clearanceOfEnds);

}  // namespace clearway::planning
