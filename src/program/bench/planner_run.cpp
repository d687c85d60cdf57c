#include "program/bench/planner_run.h"

#include <ompl/base/PlannerData.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/tools/benchmark/MachineSpecs.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <ctime>
#include <mutex>
#include <thread>

#include "clearway/planning/problem_setup.h"
#include "core/clock.h"
#include "core/number.h"
#include "planning/plan/finish.h"

namespace clearway::study {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;
using planning::PathAudit;
using planning::PlanSetup;

constexpr double kLeastPeriod = 0.05;   ///< seconds between two looks at a planner's progress
constexpr double kLooksPerRun = 500;    ///< most looks in a run of limited time
constexpr double kUnlimitedPeriod = 1;  ///< seconds between two looks in a run of unlimited time

std::string flag(bool value) {
    return value ? "1" : "0";
}

std::string textOf(double value) {
    return shortNumber(value);
}

std::string textOf(std::uint64_t value) {
    return std::to_string(value);
}

/// Watches the process's memory and the planner's progress during planning, from a thread of its own.
class RunWatch {
  public:
    /// bytes: the most that the process may use. period: seconds between two looks.
    RunWatch(const ob::Planner& planner, unsigned long long bytes, double period)
        : properties_(planner.getPlannerProgressProperties()),
          thread_([this, bytes, period] { run(bytes, period); }) {}
    ~RunWatch() { finish(); }
    RunWatch(const RunWatch&) = delete;
    RunWatch& operator=(const RunWatch&) = delete;

    bool isOutOfMemory() const { return isOutOfMemory_.load(std::memory_order_relaxed); }

    /// Ends the watch. Returns the planner's progress, one entry a look; none from planners that report none.
    std::vector<Properties> finish() {
        if (!thread_.joinable()) return {};
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            isEnded_ = true;
        }
        ended_.notify_one();
        thread_.join();
        return std::move(progress_);
    }

  private:
    void run(unsigned long long bytes, double period) {
        const Clock::time_point begin = Clock::now();
        std::unique_lock<std::mutex> lock(mutex_);
        while (!ended_.wait_for(lock, std::chrono::duration<double>(period), [this] { return isEnded_; })) {
            if (ompl::machine::getProcessMemoryUsage() > bytes) isOutOfMemory_ = true;
            if (properties_.empty()) continue;
            Properties now = {{"time REAL", shortNumber(secondsSince(begin))}};
            for (const auto& [name, value] : properties_) now[name] = value();
            progress_.push_back(now);
        }
    }

    ob::Planner::PlannerProgressProperties properties_;
    std::vector<Properties> progress_;
    std::atomic<bool> isOutOfMemory_{false};
    std::mutex mutex_;
    std::condition_variable ended_;
    bool isEnded_ = false;
    std::thread thread_;  ///< the last member, as it uses the others
};

/// The times of the first and the last solution of a planner that improves its solution.
class Improvements {
  public:
    Improvements(ob::ProblemDefinition& definition, Clock::time_point begin) : definition_(definition) {
        definition.setIntermediateSolutionCallback(
            [this, begin](const ob::Planner*, const std::vector<const ob::State*>&, const ob::Cost) {
                last_ = secondsSince(begin);
                if (!first_) first_ = last_;
                hasFound_ = true;
            });
    }
    ~Improvements() { definition_.setIntermediateSolutionCallback(nullptr); }
    Improvements(const Improvements&) = delete;
    Improvements& operator=(const Improvements&) = delete;

    /// The time of the first improvement; empty for planners that end with their first solution.
    const Measure& first() const { return first_; }
    const Measure& last() const { return last_; }
    /// Asked while planners run, from any of their threads.
    bool hasFound() const { return hasFound_; }

  private:
    ob::ProblemDefinition& definition_;
    Measure first_, last_;
    std::atomic<bool> hasFound_{false};
};

/// Decides when a run's planner must end. Asked also within motions, and from several threads.
class RunEnd {
  public:
    explicit RunEnd(const RunLimits& limits) : limits_(limits) {}

    void begin() { begin_ = Clock::now(); }
    double seconds() const { return secondsSince(begin_.value()); }
    bool isStopped() const { return limits_.isStopped && limits_.isStopped(); }
    bool isReached() const { return (begin_ && seconds() >= limits_.seconds) || isStopped(); }
    bool spendIteration() { return isReached() || (limits_.iterations && ++asked_ > *limits_.iterations); }

  private:
    const RunLimits& limits_;
    std::optional<Clock::time_point> begin_;
    std::atomic<std::uint64_t> asked_{0};  // several threads may ask
};

void solve(const PlanSetup& setup, const RunLimits& limits, RunEnd& end, BenchmarkRun& run,
           std::vector<std::string>& warnings) {
    ob::Planner& planner = *setup.planners[0];
    RunMeasures& measures = run.measures;
    const double period = std::isfinite(limits.seconds)
                              ? std::max(kLeastPeriod, limits.seconds / kLooksPerRun)
                              : kUnlimitedPeriod;
    RunWatch watch(planner, limits.bytes, period);
    if (limits.watch) limits.watch->begin();
    const std::clock_t processorBegin = std::clock();
    end.begin();
    const Improvements improvements(*setup.definition, Clock::now());
    const ob::PlannerTerminationCondition isSpent([&] {
        if (limits.endsAtFirstPath && (improvements.hasFound() || setup.definition->hasExactSolution()))
            return true;
        return end.spendIteration() || watch.isOutOfMemory();
    });
    ob::PlannerStatus status = ob::PlannerStatus::CRASH;
    try {
        status = planner.solve(isSpent);
    } catch (const std::exception& error) {
        warnings.push_back("planner " + planner.getName() + " ended with an exception: " + error.what());
    }
    const double seconds = end.seconds();
    measures.seconds = seconds;
    measures.processorSeconds = static_cast<double>(std::clock() - processorBegin) / CLOCKS_PER_SEC;
    run.progress = watch.finish();
    if (limits.watch) limits.watch->end(measures);
    if (setup.definition->hasExactSolution()) {
        measures.firstSolutionSeconds = improvements.first().value_or(seconds);
        measures.finalSolutionSeconds = improvements.last().value_or(seconds);
    }
    measures.status = static_cast<std::uint64_t>(static_cast<ob::PlannerStatus::StatusType>(status));
}

void describeAnswers(const PlanSetup& setup, BenchmarkRun& run) {
    const auto put = [&](const char* name, std::uint64_t count) {
        run.properties[name] = std::to_string(count);
    };
    const planning::CheckCounters checks = setup.checker->counters();
    run.measures.stateChecks = checks.checks;
    put("invalid state checks INTEGER", checks.invalid);
    run.properties["valid segment fraction REAL"] =
        shortNumber(setup.si->getMotionValidator()->getValidMotionFraction());
    const planning::MotionCounters motions = setup.certified->counters();
    put("valid motions INTEGER", motions.valid);
    put("invalid motions INTEGER", motions.invalid);
    run.measures.undecidedMotions = motions.undecided;
    put("motion queries INTEGER", motions.queries);
}

void describeGraph(const PlanSetup& setup, BenchmarkRun& run) {
    ob::PlannerData graph(setup.si);
    setup.planners[0]->getPlannerData(graph);
    run.measures.graphStates = graph.numVertices();
    run.measures.graphMotions = graph.numEdges();
    for (const auto& [name, value] : graph.properties) run.properties[name] = value;
}

/// which: "" or "simplified ", before OMPL's names. Unlike OMPL, which looks at states, "correct" and
/// "strict" come from certifying the path.
PathMeasures describePath(const PlanSetup& setup, const og::PathGeometric& path, const PathAudit& found,
                          const std::string& which, Properties& properties) {
    properties[which + "solution smoothness REAL"] = shortNumber(path.smoothness());
    properties[which + "solution clearance REAL"] = shortNumber(path.clearance());
    properties[which + "solution segments INTEGER"] =
        std::to_string(std::max<std::size_t>(path.getStateCount(), 1) - 1);
    properties[which + "correct solution BOOLEAN"] = flag(found.verdict != planning::MotionVerdict::kInvalid);
    PathMeasures measures;
    measures.length = path.length();
    measures.isCertified = found.isValid();
    measures.leastClearance = found.lowerClearance;
    if (const auto& objective = setup.definition->getOptimizationObjective()) {
        measures.cost = std::make_shared<og::PathGeometric>(path)->cost(objective).value();
    }
    return measures;
}

void keepPath(const og::PathGeometric& path, BenchmarkRun& run) {
    run.length = path.length();
    run.path = planning::partStates(path);
}

void describeSolution(const PlanSetup& setup, bool simplify, const RunEnd& end, BenchmarkRun& run) {
    Properties& properties = run.properties;
    properties["approximate solution BOOLEAN"] = flag(setup.definition->hasApproximateSolution());
    properties["solution difference REAL"] = shortNumber(setup.definition->getSolutionDifference());
    og::PathGeometric path = pathOf(setup, solutionOf(setup));
    static_cast<PathMeasures&>(run.measures) =
        describePath(setup, path, audit(path, *setup.auditor), "", properties);
    if (simplify) {
        const Clock::time_point begin = Clock::now();
        const PathAudit found = finish(setup, path, [&] { return end.isStopped(); });
        properties["simplification time REAL"] = shortNumber(secondsSince(begin));
        RunMeasures simplified;
        static_cast<PathMeasures&>(simplified) = describePath(setup, path, found, "simplified ", properties);
        for (const auto& [name, text] : propertiesOf(simplified)) properties["simplified " + name] = text;
    }
    if (run.isSolved) keepPath(path, run);
}

}  // namespace

Work::Work(const QueryTally& tally)
    : distanceQueries(tally.distances),
      withinQueries(tally.withins),
      sweepQueries(tally.sweeps),
      volumeTests(tally.work.volumeTests),
      triangleTests(tally.work.triangleTests),
      triangleLanes(tally.work.triangleLanes),
      kernelPairs(tally.work.kernelPairs),
      kernelLanes(tally.work.kernelLanes) {}

double Work::queries() const {
    double sum = 0;
    for (const Count& count : {distanceQueries, withinQueries, sweepQueries})
        sum += static_cast<double>(count.value_or(0));
    return sum;
}

const std::vector<RunProperty>& runProperties() {
    using Run = RunMeasures;
    static const std::vector<RunProperty> kProperties = {
        {"solved", "solved BOOLEAN", &Run::isSolved},
        {"status", "status ENUM", &Run::status},
        {"seconds", "time REAL", &Run::seconds},
        // Processor seconds are less than clock seconds when the machine did other work.
        {"processor_seconds", "processor time REAL", &Run::processorSeconds},
        {"first_solution_seconds", "time to first solution REAL", &Run::firstSolutionSeconds},
        {"final_solution_seconds", "time to final solution REAL", &Run::finalSolutionSeconds},
        {"cost", "solution cost REAL", &Run::cost},
        {"length", "solution length REAL", &Run::length},
        {"least_clearance", "least clearance REAL", &Run::leastClearance},
        {"certified", "correct solution strict BOOLEAN", &Run::isCertified},
        {"state_checks", "state checks INTEGER", &Run::stateChecks},
        {"motion_checks", "motion checks INTEGER", &Run::motionChecks},
        {"undecided_motions", "undecided motions INTEGER", &Run::undecidedMotions},
        {"distance_queries", "distance queries INTEGER", &Run::distanceQueries},
        {"within_queries", "within queries INTEGER", &Run::withinQueries},
        {"sweep_queries", "sweep queries INTEGER", &Run::sweepQueries},
        {"query_seconds", "query time REAL", &Run::querySeconds},
        {"query_share", "query share REAL", &Run::queryShare},
        {"volume_tests", "volume tests INTEGER", &Run::volumeTests},
        {"triangle_tests", "triangle tests INTEGER", &Run::triangleTests},
        {"triangle_lanes", "triangle lanes INTEGER", &Run::triangleLanes},
        {"kernel_pairs", "kernel pairs INTEGER", &Run::kernelPairs},
        {"kernel_lanes", "kernel lanes INTEGER", &Run::kernelLanes},
        {"graph_states", "graph states INTEGER", &Run::graphStates},
        {"graph_motions", "graph motions INTEGER", &Run::graphMotions},
        {"megabytes", "memory REAL", &Run::megabytes},
    };
    return kProperties;
}

Properties propertiesOf(const RunMeasures& measures) {
    Properties properties;
    for (const RunProperty& each : runProperties()) {
        const auto put = [&](auto member) {
            if (measures.*member) properties[each.property] = textOf(*(measures.*member));
        };
        std::visit(put, each.member);
    }
    return properties;
}

std::optional<BenchmarkRun> runOnce(const Problem& problem, const Scene& scene,
                                    const planning::PlanOptions& options, const RunLimits& limits,
                                    std::vector<std::string>& warnings) {
    planning::PlanReport settings;
    RunEnd end(limits);
    const auto isOver = [&] { return end.isReached(); };
    const auto join = [&](PlanSetup& setup) {
        if (limits.watch) limits.watch->join(setup, isOver);
    };
    const PlanSetup setup = planning::makePlanSetup(problem, scene, options, settings, isOver, join);
    BenchmarkRun run;
    solve(setup, limits, end, run, warnings);
    if (end.isStopped()) return std::nullopt;

    run.measures.megabytes = static_cast<double>(ompl::machine::getProcessMemoryUsage()) / kBytesPerMegabyte;
    run.isSolved = setup.definition->hasExactSolution();
    run.measures.isSolved = run.isSolved;
    run.properties["seed INTEGER"] = std::to_string(options.seed);
    describeAnswers(setup, run);
    describeGraph(setup, run);
    if (setup.definition->hasSolution()) describeSolution(setup, limits.simplify, end, run);
    run.properties.merge(propertiesOf(run.measures));
    if (end.isStopped()) return std::nullopt;
    return run;
}

}  // namespace clearway::study
