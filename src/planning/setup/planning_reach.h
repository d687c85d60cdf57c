// How much of an environment planning a problem can need.
#pragma once

#include <optional>

#include "clearway/model.h"
#include "clearway/problem.h"
#include "clearway/scene.h"
#include "planning/setup/plan.h"

namespace clearway::planning {

/// What plan() needs an environment's model to hold: all positions within the problem's bounds, and distances
/// up to the problem's largest margin and the step (as plan() finds it), or what an objective of clearance
/// asks for, with the part's diameter on top, so that clearances are told that far. Nothing when clearances
/// of any size decide what is found (the sampler max_clearance). environmentBox: of the whole environment.
/// Throws std::invalid_argument as boundsOf does.
std::optional<Reach> planningReach(const Problem& problem, const PlanOptions& options, const Model& part,
                                   const Box& environmentBox);

/// Throws std::invalid_argument when the environment was built with a reach that lacks positions within the
/// bounds, or ends before margin + step. The part's radius is for the queries to judge.
void requireReachOf(const Scene& scene, const Box& bounds, double step);

/// The step that the options or the problem give, else 1/500 of the part's diagonal.
double stepOf(const Problem& problem, const PlanOptions& options, const Model& part);

}  // namespace clearway::planning
