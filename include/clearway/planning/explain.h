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
    /// The planner, its parameters, seed and threads are those of every trial, and so are its iterations, which
    /// make the explanation repeatable as long as the time lasts. The time, the objective and the floor do not count.
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

/// Plans again without the obstacles that stopped most motions, then puts back, one by one, those without which no path
/// is lost. Of the obstacles left out only those that a path runs into are needed to be out. Then scales all margins
/// alike, by bisection. Leaves out nothing where there is one obstacle, or one without a name. `why`: of the planning that
/// found no path. Throws ArgumentError when options.seconds is not above 0, and as requireExplainable and plan do.
/// Source: greedy minimum constraint removal after Hauser, The Minimum Constraint Removal Problem with Three Robotics
/// Applications, 2012.
Explanation explain(const Problem& problem, const WhyNoPath& why, const ExplainOptions& options);

}  // namespace clearway::planning

#pragma GCC visibility pop
