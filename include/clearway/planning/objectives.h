// Optimisation objectives by name: OMPL.app's and clearway's.
#pragma once

#include <ompl/base/OptimizationObjective.h>
#include <ompl/base/SpaceInformation.h>

#include <optional>
#include <string>
#include <vector>

#include "clearway/planning/shared_scene.h"

#pragma GCC visibility push(default)

namespace clearway::planning {

/// An objective by its name, with its one option.
struct ObjectiveChoice {
    std::string name;                       ///< as objectiveName returns it
    std::optional<double> wantedClearance;  ///< see LengthWithClearanceOptions
};

/// All names of objectives: "length", "max_min_clearance" and "mechanical_work", as OMPL.app names them,
/// "clearance_integral" and "length_with_clearance".
std::vector<std::string> objectiveNames();

/// Returns the one of objectiveNames() that is written in any case; "min_clearance" means max_min_clearance.
/// Throws ArgumentError that lists the names.
std::string objectiveName(const std::string& name);

/// Makes the objective of the given name. Throws as objectiveName and the constructor of the objective do.
ompl::base::OptimizationObjectivePtr makeObjective(const ompl::base::SpaceInformationPtr& si,
                                                   const SharedScene& scene, const ObjectiveChoice& choice);

/// The clearance above which the objective sees no difference, in environment units; infinite where there is none; 0 for an
/// objective that does not depend on clearance. Throws as objectiveName does, and when the wanted clearance is not finite
/// and above 0.
double largestClearance(const ObjectiveChoice& choice, const Model& part);

}  // namespace clearway::planning

#pragma GCC visibility pop
