// Where no path was found: without which obstacles, and with how much less margin, one is found.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "clearway/planning/plan.h"

#pragma GCC visibility push(default)

namespace clearway::planning {

/// How explain() plans its trials, and for how long.
struct ExplainOptions {
    /// Every trial uses its planner (unless it has an objective), parameters, seed, threads and iterations. With
    /// iterations the explanation is repeatable if the time suffices. Its seconds, objective, wantedClearance, floor
    /// and onOverrun are ignored.
    PlanOptions plan;
    double seconds = 60;  ///< > 0; for all trials
    /// Loads the scene of a problem that differs from the given one in rules.apart only.
    std::function<Scene(const Problem& problem)> load;
};

/// The answer of explain().
struct Explanation {
    bool areObstaclesTried = false;  ///< there are at least two obstacles, all with names
    /// Sets of obstacles without which a path was found, each of as few obstacles as any. Greedy: smaller sets may
    /// exist. Empty: none was found, or none was tried.
    std::vector<std::vector<std::string>> withoutThese;
    /// The largest factor of all margins with which a path was found. Nothing: no path was found even with
    /// margins of 0, or no margin is above 0.
    std::optional<double> marginScale;
    double refusedScale = 1;     ///< the least factor of all margins with which no path was found
    bool isMarginTried = false;  ///< a trial with margins of 0 was made to its end
    /// A path that a trial found and that is valid with all obstacles and whole margins. Planning only missed it.
    std::vector<PartState> path;
    std::size_t trials = 0;    ///< how often was planned
    double trialSeconds = 0;   ///< the most that a trial plans; 0 with iterations
    bool isOutOfTime = false;  ///< trials were left out for want of time, or because it was interrupted
    bool isStopped = false;    ///< PlanOptions::isStopped ended the trials
};

/// True when the scene has a margin above 0, or at least two obstacles, the components of its meshes, all with names.
bool isExplainable(const Scene& scene);

/// Throws ArgumentError that says what is missing, unless isExplainable.
void requireExplainable(const Scene& scene);

/// Plans again without the obstacles that blocked most motions. Puts back all that the path found does not run into,
/// then others, half of them at once and in the end one by one, while a path is still found. Then bisects for the
/// largest common factor of all margins with which a path is found. Obstacles are left out only if there are at least
/// two, all with names. why: the report of the planning that found no path. Throws ArgumentError when options.seconds
/// is not above 0, and as requireExplainable and plan do. Source: greedy minimum constraint removal after Hauser, The
/// Minimum Constraint Removal Problem with Three Robotics Applications, 2012.
Explanation explain(const Problem& problem, const WhyNoPath& why, const ExplainOptions& options);

}  // namespace clearway::planning

#pragma GCC visibility pop
