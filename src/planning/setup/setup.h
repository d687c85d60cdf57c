// Everything a planner needs, made from a problem: space, checker, motion validator, planners with their
// parameters.
#pragma once

#include <ompl/base/Planner.h>
#include <ompl/base/SpaceInformation.h>

#include <functional>
#include <memory>
#include <vector>

#include "clearway/planning/discrete_motion_validator.h"
#include "clearway/planning/motion_validator.h"
#include "clearway/planning/validity_checker.h"
#include "planning/setup/plan.h"

namespace clearway::planning {

struct Setup {
    ompl::base::SpaceInformationPtr si;
    std::shared_ptr<ValidityChecker> truth;    ///< the margin itself
    std::shared_ptr<ValidityChecker> checker;  ///< the planners' own: the guard, if any, on top of the margin
    /// The planners' own is one of these two, the other one is null: the second with a step asked for.
    std::shared_ptr<MotionValidator> certified;
    std::shared_ptr<DiscreteMotionValidator> discrete;
    /// Judges the path at last, with and without a step; shortens it without.
    std::shared_ptr<MotionValidator> auditor;
    double floor = 0;  ///< clearance that shortening keeps, without a step
    ompl::base::ProblemDefinitionPtr definition;
    std::vector<ompl::base::PlannerPtr> planners;  ///< as report.planners names them
};

/// Fills the report's settings and warnings as it goes. isOver: asked within the planners' certified motions,
/// true leaves them undecided. beforePlanners: may put another checker, validator or objective in place before
/// planners see them. Throws std::invalid_argument as plan() does.
Setup prepare(const Problem& problem, const Scene& scene, const PlanOptions& options, PlanReport& report,
              const std::function<bool()>& isOver = {},
              const std::function<void(Setup&)>& beforePlanners = {});

}  // namespace clearway::planning
