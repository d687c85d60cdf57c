// From a problem to a path: one call around OMPL, from the check of the start state to the audit of the
// simplified path.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "clearway/errors.h"
#include "clearway/planning/audit.h"
#include "clearway/planning/why_no_path.h"
#include "clearway/problem.h"
#include "clearway/scene.h"
#include "clearway/scene_clearance.h"

#pragma GCC visibility push(default)

namespace clearway::planning {

/// How long plan() plans, in seconds, unless PlanOptions sets a limit.
constexpr double kDefaultSeconds = 30;

struct PlanReport;

/// An option that is wrong in itself or contradicts another one: nothing was planned.
class RefusedOption : public ArgumentError {
  public:
    using ArgumentError::ArgumentError;  ///< takes the message
};

/// The start is in collision. The message names what the part touches, and the keys that let a problem begin there.
class InvalidStart : public ArgumentError {
  public:
    /// Takes the message.
    InvalidStart(const std::string& message, bool theMayOverlap)
        : ArgumentError(message), mayOverlap(theMayOverlap) {}

    bool
        mayOverlap;  ///< whether allowing an overlap is one of the remedies named; OverlapMeter measures the overlap
};

/// Seconds after PlanOptions::seconds, or after PlanOptions::isStopped first returned true, from which plan() overruns.
constexpr double kMostOverrun = 1.25;

/// The phases of plan(), in order.
enum class PlanPhase {
    kPlanning,   ///< the planners look for a path
    kWidening,   ///< the path is widened, where that is wanted
    kFinishing,  ///< the path is shortened and audited
    kAskingWhy   ///< there is no path, and the reason is looked for
};

/// How plan() plans: the planner, its limits, and what the path keeps.
struct PlanOptions {
    /// OMPL's class name in any case. Empty: the problem's planner when it names exactly one, else
    /// PlannerTeam. With an objective the default is RisingFloor for the least clearance and
    /// AnytimePathShortening of RRTConnect and RRT for the others, or RRTstar with iterations.
    std::string planner;
    /// Parameters of this planner, on top of the problem's. An unknown parameter is an error; in a file of
    /// OMPL.app's it only gives a warning.
    std::vector<std::pair<std::string, std::string>> parameters;

    /// plan() ends after `seconds`, and where no path was found up to a second later, in which it looks for the reason; planners
    /// with large trees end before the limit, so that these can be read. Or the planner ends after `iterations`
    /// evaluations of the termination condition, which most planners do once an iteration and which is the repeatable
    /// limit. Give at most one of the two. Without either the limit is kDefaultSeconds.
    std::optional<double> seconds;
    std::optional<std::uint64_t> iterations;  ///< the repeatable limit; see `seconds`

    /// How many planners run side by side until the first one has a path. A planner with threads of its own
    /// runs alone. 0: one for each core, at most 4. With iterations only one planner runs at a
    /// time.
    int threads = 0;

    /// > 0; set before any OMPL object is made. OMPL has one generator of seeds: another plan() at the same time takes
    /// seeds from it, too, and no path is repeatable then.
    std::uint32_t seed = 1;
    /// Clearance that shortening the path keeps, in environment units, see simplify(). The default is a share
    /// of the part's diagonal.
    std::optional<double> floor;
    /// The objective of planners that can go on improving a path for all the time they have, see
    /// objectiveNames(). Empty: the problem's objective, unless that is length without a threshold.
    std::string objective;
    std::optional<double> wantedClearance;  ///< see LengthWithClearanceOptions; for this objective alone
    /// Leaves out widening, the step after planning (see PlanReport::widening). Not allowed together with an objective, which
    /// leaves it out anyway.
    bool quick = false;
    bool omplWeights = false;  ///< weights rotation as OMPL does, instead of by the part's radius

    /// Called often, also from other threads and within motions. True ends planning and shortening: the best path
    /// so far, if there is one, is audited and returned.
    std::function<bool()> isStopped;
    /// Called when a phase begins, in the thread that called plan().
    std::function<void(PlanPhase)> onPhase;
    /// Some of OMPL's planners overrun, because they evaluate the termination condition only between long pieces of
    /// work. Of those of OMPL 1.5, BITstar, LazyPRMstar, LBKPIECE1, pSBL and SBL do. Others may where a single motion
    /// takes long. plan() cannot end a planner, and waits for it. When it has waited kMostOverrun, it calls onOverrun
    /// from another thread, with the report of the best path so far, audited, but neither widened nor shortened. Who
    /// can't wait writes it and ends the process.
    std::function<void(const PlanReport&)> onOverrun;
};

/// A path's clearance before and after widening, the step between planning and shortening.
struct WideningReport {
    double before = 0;   ///< clearance that all motions keep, certified, to 10 %; environment units
    double after = 0;    ///< clearance that the widened path keeps, to 1 %; shortening keeps it too
    double seconds = 0;  ///< that widening took
};

/// The path, if there is one, and how it was found. Lengths in environment units.
struct PlanReport {
    /// The ways in which planning can end.
    enum class Outcome {
        kFound,     ///< there is a path
        kNotFound,  ///< the time or the iterations are spent, or the path did not pass its audit
        kStopped    ///< stopped before there was a path
    };
    Outcome outcome = Outcome::kNotFound;  ///< how planning ended
    bool isStopped = false;                ///< PlanOptions::isStopped ended the planning or the shortening
    std::vector<std::string> planners;     ///< those that ran side by side
    unsigned int threads = 1;   ///< that plan at a time, where planners do not choose for themselves
    std::string foundBy;        ///< OMPL's name of the planner that found the path
    std::string objective;      ///< name of the objective; empty: the first path is taken
    double cost = 0;            ///< the path's cost by the objective, if there is one
    bool isRepeatable = false;  ///< with the same seed and number of iterations
    double range = 0;  ///< longest edge of a planner's tree, unless the planner's parameters set another one

    std::vector<PartState> path;   ///< empty unless found
    double length = 0;             ///< travelled by the origin of the part's coordinates
    double rotation = 0;           ///< radians, summed over the path
    std::size_t statesBefore = 0;  ///< in the path as the planner found it
    double floor = 0;              ///< clearance that shortening kept, where the planner's path kept it
    PathAudit audit;               ///< of the path, which is valid along its whole length

    /// Paths are widened before they are shortened: their states are pushed away from obstacles, and planners
    /// look for other paths, some with more clearance and some that wind less with about as much clearance. This takes about as
    /// long as the planning, from 1 to 5 seconds, and no more than half of the time left; up to three times as long, within
    /// 5 seconds, while the clearance still grows fast. With iterations no other ways
    /// are looked for, and the states are pushed a number of times in proportion to the iterations spent; the path is then
    /// repeatable, but with another tree of the same environment (as with another range) it is another path. Empty with
    /// PlanOptions::quick, with an objective, and when no path was found.
    std::optional<WideningReport> widening;

    /// There is no path, and nothing was planned. Obstacles that are ignored in a contact zone, or may overlap the part, prove
    /// nothing.
    std::optional<ShutIn> shutIn;

    /// Why no path was found. Empty with a path, with a proof (shutIn), for a path that did not pass its audit, and
    /// when planning was stopped before the reason was searched for.
    std::optional<WhyNoPath> whyNoPath;

    double planningSeconds = 0;  ///< for running the planners
    double finishingSeconds =
        0;  ///< for widening, simplifying and auditing, or for finding out why there is no path
    std::uint64_t checks = 0;  ///< states checked, plus the queries about motions and those of the audit
    std::vector<std::string> warnings;  ///< of clearway and of OMPL, one text each
};

/// Plans for the scene. The scene's margins count; the problem's own margin and mesh files do not. The path
/// begins at the problem's start, ends at its goal, and is valid along its whole length. Throws ArgumentError
/// when an option is wrong, the problem names an unknown planner, the bounds leave out the start or the goal or
/// leave the part no place outside, the environment was built with too small a range (see planningRange), or the
/// start or goal is not valid: the message then says why (WhyInvalid::words). A start in collision throws
/// InvalidStart. Throws OmplError when OMPL throws.
PlanReport plan(const Problem& problem, const Scene& scene, const PlanOptions& options);

/// Looks up the names of the problem's objective, samplers, planners and planners' parameters. Throws
/// ArgumentError for an unknown one, with the known names. In a file of OMPL.app's, which has no section
/// [clearway], an unknown name only gives a warning: such files hold names that OMPL no longer has.
std::vector<std::string> unknownNames(const Problem& problem);

/// The range that plan() and checkPath() need of an environment's model: all positions within the problem's
/// bounds, and distances up to the problem's largest margin plus its fineness (else 1/500 of the part's diagonal) or,
/// where that is more, the largest clearance that an objective distinguishes, plus the part's diameter. Nothing
/// when clearances of any size decide what is found (the sampler max_clearance, the objective max_min_clearance). environmentBox: the box of
/// the whole environment. Throws ArgumentError as boundsOf does.
std::optional<QueryRange> planningRange(const Problem& problem, const PlanOptions& options, const Model& part,
                                        const Box& environmentBox);

}  // namespace clearway::planning

#pragma GCC visibility pop
