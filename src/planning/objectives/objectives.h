// Objectives by name, OMPL.app's and clearway's.
#pragma once

#include <ompl/base/OptimizationObjective.h>
#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/SpaceInformation.h>

#include <optional>
#include <string>
#include <vector>

#include "clearway/scene.h"

namespace clearway::planning {

struct ObjectiveChoice {
    std::string name;                       ///< as objectiveName returns it
    std::optional<double> wantedClearance;  ///< see LengthWithClearanceOptions
};

/// "length", "max_min_clearance" and "mechanical_work", as OMPL.app names them, "clearance_integral" and
/// "length_with_clearance".
std::vector<std::string> objectiveNames();

/// One of them, written in any case; "min_clearance" is max_min_clearance. Throws std::invalid_argument that
/// lists the names.
std::string objectiveName(const std::string& name);

/// Throws as the objectives do.
ompl::base::OptimizationObjectivePtr makeObjective(const ompl::base::SpaceInformationPtr& si,
                                                   const Scene& scene, const ObjectiveChoice& choice);

/// Larger clearances are all the same to it; 0 for an objective that asks for none. Environment units.
double largestClearance(const ObjectiveChoice& choice, const Model& part);

/// The exact solution that costs least by the definition's objective (OMPL puts some planners' in the order
/// of their lengths), else OMPL's first. Nothing when there is no exact solution.
struct BestSolution {
    ompl::base::PlannerSolution solution;
    double cost = 0;  ///< NaN without an objective
};
std::optional<BestSolution> bestSolution(const ompl::base::ProblemDefinition& definition);

}  // namespace clearway::planning
