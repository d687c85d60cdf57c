// Everything a planner needs, made from a problem: space, checker, motion validator, planners with their
// parameters.
#pragma once

#include <ompl/base/Planner.h>
#include <ompl/base/SpaceInformation.h>

#include <memory>
#include <vector>

#include "clearway/planning/discrete_motion_validator.h"
#include "clearway/planning/validity_checker.h"
#include "planning/plan.h"

namespace clearway::planning {

struct Setup {
    ompl::base::SpaceInformationPtr si;
    std::shared_ptr<ValidityChecker> checker;  ///< the planners' own: the guard on top of the margin
    std::shared_ptr<ValidityChecker> truth;    ///< the margin itself
    std::shared_ptr<DiscreteMotionValidator> validator;
    ompl::base::ProblemDefinitionPtr definition;
    std::vector<ompl::base::PlannerPtr> planners;  ///< as report.planners names them
};

/// Fills the report's settings and warnings as it goes. Throws std::invalid_argument as plan() does.
Setup prepare(const Problem& problem, const Scene& scene, const PlanOptions& options, PlanReport& report);

}  // namespace clearway::planning
