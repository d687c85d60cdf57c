// The parts of plan(), for programs that run, time or trace the planners themselves.
#pragma once

#include <ompl/base/Planner.h>
#include <ompl/base/SpaceInformation.h>

#include <functional>
#include <memory>
#include <vector>

#include "clearway/planning/motion_validator.h"
#include "clearway/planning/plan.h"
#include "clearway/planning/validity_checker.h"

namespace clearway::planning {

/// Everything that planners need, made from a problem.
struct PlanSetup {
    ompl::base::SpaceInformationPtr si;           ///< set up, with the checker and the motion validator below
    std::shared_ptr<ValidityChecker> checker;     ///< the planners' own
    std::shared_ptr<MotionValidator> certified;   ///< the planners' own
    std::shared_ptr<MotionValidator> auditor;     ///< certifies the shortening, and audits the final path
    std::function<bool()> isStopped;              ///< true: somebody waits for the end; never empty
    double floor = 0;                             ///< clearance that shortening keeps; environment units
    ompl::base::ProblemDefinitionPtr definition;  ///< with start and goal, and the objective if one is named
    std::vector<ompl::base::PlannerPtr> planners;  ///< set up, in the order of report.planners
};

/// Makes the space, checker, validators and planners for a problem, and fills in the report's settings and
/// warnings. isOver: called within the planners' motions; true leaves a motion undecided.
/// beforePlanners: may replace the checker, validator or objective before the planners see them. Throws
/// ArgumentError as plan() does.
PlanSetup makePlanSetup(const Problem& problem, const Scene& scene, const PlanOptions& options,
                        PlanReport& report, const std::function<bool()>& isOver = {},
                        const std::function<void(PlanSetup&)>& beforePlanners = {});

}  // namespace clearway::planning
