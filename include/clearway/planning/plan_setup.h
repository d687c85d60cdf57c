// plan() in steps, for programs that run, time or trace the planners themselves.
#pragma once

#include <ompl/base/Planner.h>
#include <ompl/base/SpaceInformation.h>

#include <functional>
#include <memory>
#include <vector>

#include "clearway/planning/discrete_motion_validator.h"
#include "clearway/planning/motion_validator.h"
#include "clearway/planning/plan.h"
#include "clearway/planning/validity_checker.h"

#pragma GCC visibility push(default)

namespace clearway::planning {

/// Everything that planners need, made from a problem.
struct PlanSetup {
    ompl::base::SpaceInformationPtr si;        ///< set up, with the checker and the motion validator below
    std::shared_ptr<ValidityChecker> truth;    ///< checks the scene's margins themselves
    std::shared_ptr<ValidityChecker> checker;  ///< the planners' own: adds the guard, if any, to the margins
    /// The planners' own motion validator without a step; null with a step.
    std::shared_ptr<MotionValidator> certified;
    /// The planners' own motion validator with a step; null without one.
    std::shared_ptr<DiscreteMotionValidator> discrete;
    /// Audits the final path, with and without a step. Without a step it also certifies the shortening.
    std::shared_ptr<MotionValidator> auditor;
    double floor = 0;  ///< clearance that shortening keeps, without a step; environment units
    ompl::base::ProblemDefinitionPtr definition;   ///< with start and goal, and the objective if one is named
    std::vector<ompl::base::PlannerPtr> planners;  ///< set up, in the order of report.planners
};

/// Makes the space, checkers, validators and planners for a problem, and fills in the report's settings and
/// warnings. isOver: called within the planners' motions; true leaves a certified motion undecided and makes one in steps invalid.
/// beforePlanners: may replace the checker, validator or objective before the planners see them. Throws
/// std::invalid_argument as plan() does.
PlanSetup makePlanSetup(const Problem& problem, const Scene& scene, const PlanOptions& options,
                        PlanReport& report, const std::function<bool()>& isOver = {},
                        const std::function<void(PlanSetup&)>& beforePlanners = {});

}  // namespace clearway::planning

#pragma GCC visibility pop
