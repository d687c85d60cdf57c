// A problem as OMPL takes it, and paths between the two.
#pragma once

#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/SimpleSetup.h>

#include <vector>

#include "clearway/planning/motion_validator.h"
#include "clearway/problem.h"
#include "clearway/scene.h"

namespace clearway::planning {

/// OMPL's setup of a problem in a scene: SE(3) or SE(2) within the problem's bounds, its start and goal, a
/// ValidityChecker, and a MotionValidator, which certifies motions. A rotation counts as far as it moves the
/// part's outermost point, where OMPL would count radians as environment units. What the problem sets of the
/// space and of the sampler is set; what neither has is warned of through OMPL's console. Planner and
/// objective are left to the caller: the problem's own are names and texts in it.
///
/// The scene's margins count, not the problem's. Throws std::invalid_argument as boundsOf, ValidityChecker
/// and MotionValidator do, for a setting that OMPL refuses, and when start or goal is not valid: then it says
/// why, naming the two closest meshes and triangles.
ompl::geometric::SimpleSetup makeSetup(const Problem& problem, const Scene& scene);

/// The motion validator that si has. Throws std::invalid_argument when si is null or has none that certifies
/// motions.
const MotionValidator& motionValidatorOf(const ompl::base::SpaceInformationPtr& si);

/// The states of a path as path files have them (writePath), and back. Both throw std::invalid_argument when
/// the space is neither SE(3) nor SE(2).
std::vector<PartState> partStates(const ompl::geometric::PathGeometric& path);
ompl::geometric::PathGeometric pathThrough(const ompl::base::SpaceInformationPtr& si,
                                           const std::vector<PartState>& states);

}  // namespace clearway::planning
