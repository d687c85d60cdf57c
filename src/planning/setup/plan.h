// From a problem to a path: one call around OMPL, from the start state's check to the simplified, re-checked
// path.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "clearway/planning/audit.h"
#include "clearway/problem.h"
#include "clearway/scene.h"

namespace clearway::planning {

constexpr double kDefaultSeconds = 30;

struct PlanOptions {
    /// OMPL's class name in any case. Empty: the problem's planner when it names exactly one, else
    /// RRTConnect and RRT side by side; for the least clearance RisingFloor, for other objectives of
    /// clearance AnytimePathShortening of the two, or RRTstar with iterations.
    std::string planner;
    /// On top of the problem's for this planner. An unknown one is refused; the problem's unknown ones are
    /// warned of.
    std::vector<std::pair<std::string, std::string>> parameters;

    /// The planner ends after so many seconds, or when it has asked so many times whether to end, which is
    /// the repeatable one: once an iteration for most planners. At most one of them; without either,
    /// kDefaultSeconds.
    std::optional<double> seconds;
    std::optional<std::uint64_t> iterations;

    /// Planners that run side by side until the first one has a path; one that uses threads of its own runs
    /// alone. 0: one for each core, at most 4. With iterations it is always 1, by default an RRTConnect.
    int threads = 0;

    std::uint32_t seed = 1;  ///< > 0; set before any OMPL object is made
    /// Motions are certified along their whole length, unless a step is given, in environment units: then
    /// they are checked at states so close that no point of the part moves further from one to the next, and
    /// what is thinner can be jumped.
    std::optional<double> step;
    /// Clearance that shortening the path keeps, in environment units, see simplify(). By default a share of
    /// the part's diagonal. Not with a step.
    std::optional<double> floor;
    /// What planners that can go on improving a path for all the time they have, see objectiveNames(). Empty:
    /// the problem's, unless that is length without a threshold.
    std::string objective;
    std::optional<double> wantedClearance;  ///< see LengthWithClearanceOptions
    bool omplWeights = false;               ///< rotation as OMPL weights it, instead of by the part's radius

    /// Asked often, also from other threads and within motions; true ends the planning without a path.
    std::function<bool()> isStopped;
};

struct PlanReport {
    enum class Outcome { kFound, kNotFound, kStopped };
    Outcome outcome = Outcome::kNotFound;
    std::vector<std::string> planners;  ///< those run side by side
    std::string foundBy;                ///< OMPL's name of the one whose path it is
    std::string objective;              ///< what was asked for by name; empty: the first path
    double cost = 0;                    ///< the path's by the objective, if there is one
    bool isRepeatable = false;          ///< with the same seed and number of iterations
    bool isCertified = false;           ///< the planners' motions were; else they were checked in steps
    /// As used: shorter than asked for when start or goal are tighter than half of it. 0 without one.
    double step = 0;
    /// Kept at checked states on top of the margin, so that all states between them are valid too.
    double guard = 0;
    double range = 0;  ///< longest edge of a planner's tree unless its parameters say otherwise

    std::vector<PartState> path;   ///< empty unless found
    double length = 0;             ///< travelled by the origin of the part's coordinates
    double turned = 0;             ///< radians, summed over the path
    std::size_t statesBefore = 0;  ///< in the path as the planner found it
    double floor = 0;              ///< clearance that shortening kept, where the planner's path did
    /// Of the path, certified whatever the planners' motions are. Valid without a step. With one it may not
    /// be: then a warning says where.
    PathAudit audit;

    double planningSeconds = 0;
    double finishingSeconds = 0;  ///< simplifying and auditing
    std::uint64_t checks = 0;     ///< states asked about, in all
    std::vector<std::string> warnings;
};

/// Plans for the scene (its margin counts; the problem's own margin and mesh files do not). The path begins
/// at the problem's start, ends at its goal, and is valid along its whole length; with a step, at every state
/// that was looked at, and its audit tells the rest. Throws
/// std::invalid_argument when an option is wrong, the problem names an unknown planner, the bounds leave out
/// the start or the goal, the environment was built with too small a reach (see planningReach), or one of the
/// two is not valid: then the message names the two closest meshes and triangles.
PlanReport plan(const Problem& problem, const Scene& scene, const PlanOptions& options);

}  // namespace clearway::planning
