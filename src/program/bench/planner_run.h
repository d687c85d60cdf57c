// Runs one planner once, and collects the properties that OMPL's benchmark logs hold.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "clearway/problem.h"
#include "clearway/scene.h"
#include "clearway/scene_clearance.h"
#include "planning/plan/plan_setup.h"

namespace clearway::study {

constexpr double kBytesPerMegabyte = 1024.0 * 1024.0;

/// Run properties as texts, keyed as in OMPL's benchmark logs. A key ends with a type: "time REAL".
using Properties = std::map<std::string, std::string>;

using Count = std::optional<std::uint64_t>;
using Measure = std::optional<double>;

/// Queries and the work that they did.
struct Work {
    Count distanceQueries, withinQueries, sweepQueries;
    Count volumeTests, triangleTests, triangleLanes, kernelPairs, kernelLanes;

    Work() = default;
    explicit Work(const QueryTally& tally);
    double queries() const;
};

struct PathMeasures {
    Measure cost;  ///< by the problem's objective, if there is one
    Measure length, leastClearance;
    Count isCertified;
};

/// The numbers of a run. A number is empty if the planner found no path, nothing was recorded, or nothing is
/// certified.
struct RunMeasures : Work, PathMeasures {
    Count isSolved, status;
    Measure seconds, processorSeconds;
    Measure firstSolutionSeconds, finalSolutionSeconds;
    Count stateChecks, motionChecks, undecidedMotions;
    Measure querySeconds;  ///< in the checker, the validator and the objective; see Recorder::seconds()
    Measure queryShare;    ///< share of `seconds`
    Count graphStates, graphMotions;
    Measure megabytes;
};

struct RunProperty {
    const char* column;    ///< its name in the study's tables
    const char* property;  ///< its name in logs
    std::variant<Count RunMeasures::*, Measure RunMeasures::*> member;
};

/// A row for each member of RunMeasures, in the order of the tables' columns.
const std::vector<RunProperty>& runProperties();

/// The measures that are not empty, as texts for a log.
Properties propertiesOf(const RunMeasures& measures);

struct BenchmarkRun {
    RunMeasures measures;
    Properties properties;             ///< the measures, and others that only logs have
    std::vector<Properties> progress;  ///< in the order of time
    bool isSolved = false;
    double length = 0;  ///< of the path, as OMPL's space measures it
    /// Simplified if paths are, else as the planner found it; empty unless solved.
    std::vector<PartState> path;
};

/// Watches what the planner of a run asks: see recordingInto().
struct CallWatch {
    /// Before planners are made. isOver: as in makePlanSetup.
    std::function<void(planning::PlanSetup&, const std::function<bool()>& isOver)> join;
    std::function<void()> begin;            ///< before the planner begins
    std::function<void(RunMeasures&)> end;  ///< after its end: adds measures
};

struct RunLimits {
    double seconds = 0;            ///< may be infinite
    unsigned long long bytes = 0;  ///< of the whole process
    bool simplify = true;
    std::function<bool()> isStopped;
    std::optional<CallWatch> watch = {};
    std::optional<std::uint64_t> iterations = {};  ///< how often the planner may ask whether to end
    bool endsAtFirstPath = false;                  ///< also planners that improve their path
};

/// Plans the problem, which names one planner, with that planner and the options' seed. Returns nothing when
/// isStopped ended the run. A planner that throws has status "Crash" and a warning. Throws what
/// makePlanSetup() throws.
std::optional<BenchmarkRun> runOnce(const Problem& problem, const Scene& scene,
                                    const planning::PlanOptions& options, const RunLimits& limits,
                                    std::vector<std::string>& warnings);

}  // namespace clearway::study
