// Applies the wishes of a problem and of the options of plan(): OMPL's settings, sampler, fineness and objective.
#pragma once

#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/ValidStateSampler.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "clearway/planning/objectives.h"
#include "clearway/planning/plan.h"
#include "clearway/planning/validity_checker.h"
#include "clearway/problem.h"

namespace clearway::planning {

constexpr const char* kLeastClearance = "max_min_clearance";  // of objectiveNames()
constexpr const char* kLengthWithClearance = "length_with_clearance";

/// The problem as it is for one planner (OMPL's class name): the problem's first choice of that planner may
/// override the sampler, the objective's threshold and other settings.
Problem problemFor(const std::string& planner, const Problem& problem);

/// True when a planner of the problem may use the sampler.
bool mayUseSampler(const Problem& problem, const std::string& sampler);

/// Sets the sampler of planners that sample valid states: "uniform", "gaussian", "obstacle_based",
/// "max_clearance" or "bridge_test", as OMPL.app names them, or clearway's "contact_normal" and "narrow_gap";
/// "" leaves OMPL's default. adjust: called with each sampler that is made, also from several threads. Throws
/// ArgumentError for another name.
void setSampler(ompl::base::SpaceInformation& si, const std::string& name,
                const std::function<void(ompl::base::ValidStateSampler&)>& adjust);

/// Throws ArgumentError that lists the samplers unless the name is one of them.
void requireSampler(const std::string& name);

/// Calls si.setup(), with the problem's sampler and settings. Adds a warning for each setting that neither
/// the space nor the sampler has. Throws ArgumentError for an unknown sampler and for a value that
/// OMPL refuses.
void applySettings(ompl::base::SpaceInformation& si, const Problem& problem,
                   std::vector<std::string>& warnings);

enum class ProblemEnd { kStart, kGoal };

/// Returns the clearance of the problem's start or goal. Throws ArgumentError with the words of whyInvalid unless
/// the state is valid, and InvalidStart, which names remedies too, for a start in collision.
double requireValid(const Problem& problem, const ValidityChecker& checker, const ompl::base::State* state,
                    ProblemEnd end);

/// The problem's fineness, else 1/500 of the part's diagonal.
double finenessOf(const Problem& problem, const Model& part);

/// Throws ArgumentError when the environment was built with a range that lacks positions within the
/// bounds, or ends before margin + fineness. Queries themselves refuse a part whose radius is too large.
void requireRangeOf(const Scene& scene, const Box& bounds, double fineness);

/// The objective of the options, else of the problem. Nothing when the first path will do: where neither asks
/// for more than length without a threshold, or the problem names an unknown objective. Throws
/// ArgumentError when the options name an unknown one.
std::optional<ObjectiveChoice> chooseObjective(const Problem& problem, const PlanOptions& options);

/// Makes the objective, for a definition that has start and goal. The least clearance is capped by that of the ends, which no
/// path exceeds; it is the threshold, too. Where the choice is the problem's own objective, its threshold counts. Throws
/// ArgumentError when no path can meet that threshold, with the bound, and as makeObjective does.
ompl::base::OptimizationObjectivePtr makePlanObjective(const ompl::base::ProblemDefinition& definition,
                                                       const SharedScene& scene,
                                                       const ObjectiveChoice& choice, const Problem& problem,
                                                       double clearanceOfEnds);

}  // namespace clearway::planning
