// From a problem to OMPL's SimpleSetup, and paths to and from path files.
#pragma once

#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/SimpleSetup.h>

#include <vector>

#include "clearway/planning/motion_validator.h"
#include "clearway/problem.h"
#include "clearway/scene.h"

#pragma GCC visibility push(default)

namespace clearway::planning {

/// Makes OMPL's setup of a problem in a scene: SE(3) or SE(2) within the problem's bounds, the problem's
/// start and goal (an OutsideGoal for a goal outside), a ValidityChecker, and a MotionValidator, which certifies
/// motions. A rotation counts as far as it moves the part's outermost point, where OMPL would count radians as
/// environment units. The problem's settings of the space and the sampler are applied; a setting that neither has
/// gives a warning through OMPL's console. The caller sets the planner and the objective, which the problem holds
/// as names and texts.
///
/// The scene's margins count, not the problem's. Throws ArgumentError as boundsOf, ValidityChecker
/// and MotionValidator do, for a setting that OMPL refuses, and when start or goal is not valid: then the
/// message says why, naming the two closest meshes and triangles.
ompl::geometric::SimpleSetup makeSetup(const Problem& problem, const Scene& scene);

/// Returns si's motion validator. Throws ArgumentError when si is null or its motion validator is no
/// clearway::planning::MotionValidator.
const MotionValidator& motionValidatorOf(const ompl::base::SpaceInformationPtr& si);

/// The states of a path as path files have them (writePath). Throws ArgumentError when the space is
/// neither SE(3) nor SE(2).
std::vector<PartState> partStates(const ompl::geometric::PathGeometric& path);

/// The path through the given states, in the space of si. Throws ArgumentError when the space is
/// neither SE(3) nor SE(2).
ompl::geometric::PathGeometric pathThrough(const ompl::base::SpaceInformationPtr& si,
                                           const std::vector<PartState>& states);

}  // namespace clearway::planning

#pragma GCC visibility pop
