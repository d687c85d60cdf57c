#include "program/study/benchmark_run.h"

#include <ompl/base/PlannerData.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/tools/benchmark/MachineSpecs.h>

#include <algorithm>
#include <chrono>
#include <ctime>

#include "clearway/planning/finish.h"
#include "clearway/planning/plan_setup.h"
#include "clearway/planning/problem_setup.h"
#include "core/number.h"
#include "program/study/recorder.h"
#include "program/study/run_watch.h"

namespace clearway::study {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;
using Clock = std::chrono::steady_clock;
using planning::CheckCounters;
using planning::MotionCounters;
using planning::MotionVerdict;
using planning::PathAudit;
using planning::PlanOptions;
using planning::PlanReport;
using planning::PlanSetup;

constexpr double kLeastPeriod = 0.05;  ///< seconds between two looks at a planner's progress
constexpr double kLooksPerRun = 500;   ///< at most, in the run's time
constexpr double kBytesPerMegabyte = 1024.0 * 1024.0;

double secondsSince(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// When a planner that goes on improving its solution found one, and its last.
class Improvements {
  public:
    Improvements(ob::ProblemDefinition& definition, Clock::time_point begin) : definition_(definition) {
        definition.setIntermediateSolutionCallback(
            [this, begin](const ob::Planner*, const std::vector<const ob::State*>&, const ob::Cost) {
                last_ = secondsSince(begin);
                if (!first_) first_ = last_;
            });
    }
    ~Improvements() { definition_.setIntermediateSolutionCallback(nullptr); }
    Improvements(const Improvements&) = delete;
    Improvements& operator=(const Improvements&) = delete;

    /// Nothing of planners that end with their first solution.
    const std::optional<double>& first() const { return first_; }
    const std::optional<double>& last() const { return last_; }

  private:
    ob::ProblemDefinition& definition_;
    std::optional<double> first_, last_;
};

void describeQueries(const Recorder& recorder, double seconds, BenchmarkRun& run) {
    const planning::QueryTally& tally = recorder.tally();
    const auto put = [&](const char* name, std::uint64_t count) {
        run.properties[name] = std::to_string(count);
    };
    put("motion checks INTEGER",
        recorder.calls(CallKind::kMotion) + recorder.calls(CallKind::kForwardMotion));
    put("motion costs INTEGER", recorder.calls(CallKind::kMotionCost));
    put("distance queries INTEGER", tally.distances);
    put("within queries INTEGER", tally.withins);
    put("volume tests INTEGER", tally.work.volumeTests);
    put("triangle tests INTEGER", tally.work.triangleTests);
    put("triangle lanes INTEGER", tally.work.triangleLanes);
    put("kernel pairs INTEGER", tally.work.kernelPairs);
    put("kernel lanes INTEGER", tally.work.kernelLanes);
    run.properties["query time REAL"] = shortNumber(recorder.seconds());
    run.properties["query share REAL"] = shortNumber(seconds > 0 ? recorder.seconds() / seconds : 0);
    run.calls = recorder.sample();
}

std::string flag(bool value) {
    return value ? "1" : "0";
}

/// When a run's planner has to end. Asked within its motions too, maybe from several threads.
class RunEnd {
  public:
    explicit RunEnd(const RunLimits& limits) : limits_(limits) {}

    void begin() { begin_ = Clock::now(); }
    double seconds() const { return secondsSince(begin_.value()); }
    bool isReached() const {
        return (begin_ && seconds() >= limits_.seconds) || (limits_.isStopped && limits_.isStopped());
    }

  private:
    const RunLimits& limits_;
    std::optional<Clock::time_point> begin_;
};

ob::PlannerStatus solve(const PlanSetup& setup, const RunLimits& limits, RunEnd& end, Recorder* recorder,
                        BenchmarkRun& run, std::vector<std::string>& warnings) {
    ob::Planner& planner = *setup.planners[0];
    const double period = std::max(kLeastPeriod, limits.seconds / kLooksPerRun);
    RunWatch watch(planner, limits.bytes, period);
    if (recorder) recorder->begin();
    const std::clock_t processorBegin = std::clock();
    end.begin();
    const Improvements improvements(*setup.definition, Clock::now());
    const ob::PlannerTerminationCondition isSpent([&] { return end.isReached() || watch.isOutOfMemory(); });
    ob::PlannerStatus status = ob::PlannerStatus::CRASH;
    try {
        status = planner.solve(isSpent);
    } catch (const std::exception& error) {
        warnings.push_back("planner " + planner.getName() + " ended with an exception: " + error.what());
    }
    const double seconds = end.seconds();
    run.properties["time REAL"] = shortNumber(seconds);
    run.properties["processor time REAL"] =
        shortNumber(static_cast<double>(std::clock() - processorBegin) / CLOCKS_PER_SEC);
    run.progress = watch.finish();
    if (recorder) {
        recorder->end();
        describeQueries(*recorder, seconds, run);
    }
    if (setup.definition->hasExactSolution()) {
        run.properties["time to first solution REAL"] = shortNumber(improvements.first().value_or(seconds));
        run.properties["time to final solution REAL"] = shortNumber(improvements.last().value_or(seconds));
    }
    return status;
}

void describeAnswers(const PlanSetup& setup, Properties& properties) {
    const auto put = [&](const char* name, std::uint64_t count) { properties[name] = std::to_string(count); };
    CheckCounters checks = setup.truth->counters();
    if (setup.checker != setup.truth) checks = setup.checker->counters();
    put("state checks INTEGER", checks.checks);
    put("invalid state checks INTEGER", checks.invalid);
    properties["valid segment fraction REAL"] =
        shortNumber(setup.si->getMotionValidator()->getValidMotionFraction());
    if (!setup.certified) return;
    const MotionCounters motions = setup.certified->counters();
    put("valid motions INTEGER", motions.valid);
    put("invalid motions INTEGER", motions.invalid);
    put("undecided motions INTEGER", motions.undecided);
    put("motion queries INTEGER", motions.queries);
}

void describeGraph(const PlanSetup& setup, Properties& properties) {
    ob::PlannerData graph(setup.si);
    setup.planners[0]->getPlannerData(graph);
    properties["graph states INTEGER"] = std::to_string(graph.numVertices());
    properties["graph motions INTEGER"] = std::to_string(graph.numEdges());
    for (const auto& [name, value] : graph.properties) properties[name] = value;
}

/// which: "" or "simplified ", before OMPL's names. "correct" and "strict" are told by certifying the path,
/// where OMPL looks at states.
void describePath(const PlanSetup& setup, const og::PathGeometric& path, const PathAudit& found,
                  const std::string& which, Properties& properties) {
    properties[which + "solution length REAL"] = shortNumber(path.length());
    properties[which + "solution smoothness REAL"] = shortNumber(path.smoothness());
    properties[which + "solution clearance REAL"] = shortNumber(path.clearance());
    properties[which + "solution segments INTEGER"] =
        std::to_string(std::max<std::size_t>(path.getStateCount(), 1) - 1);
    properties[which + "correct solution BOOLEAN"] = flag(found.verdict != MotionVerdict::kInvalid);
    properties[which + "correct solution strict BOOLEAN"] = flag(found.isValid());
    properties[which + "least clearance REAL"] = shortNumber(found.lowerClearance);
    if (const auto& objective = setup.definition->getOptimizationObjective()) {
        const auto cost = std::make_shared<og::PathGeometric>(path)->cost(objective);
        properties[which + "solution cost REAL"] = shortNumber(cost.value());
    }
}

void keepPath(const og::PathGeometric& path, BenchmarkRun& run) {
    run.length = path.length();
    run.path = planning::partStates(path);
}

void describeSolution(const PlanSetup& setup, const RunLimits& limits, BenchmarkRun& run) {
    Properties& properties = run.properties;
    properties["approximate solution BOOLEAN"] = flag(setup.definition->hasApproximateSolution());
    properties["solution difference REAL"] = shortNumber(setup.definition->getSolutionDifference());
    og::PathGeometric path = pathOf(setup, solutionOf(setup));
    describePath(setup, path, audit(path, *setup.auditor), "", properties);
    if (limits.simplify) {
        const Clock::time_point begin = Clock::now();
        const PathAudit found = finish(setup, path, [&] { return limits.isStopped && limits.isStopped(); });
        properties["simplification time REAL"] = shortNumber(secondsSince(begin));
        describePath(setup, path, found, "simplified ", properties);
    }
    if (run.isSolved) keepPath(path, run);
}

}  // namespace

std::optional<BenchmarkRun> runOnce(const Problem& problem, const Scene& scene, const PlanOptions& options,
                                    const RunLimits& limits, std::vector<std::string>& warnings) {
    PlanReport settings;
    RunEnd end(limits);
    const auto isOver = [&] { return end.isReached(); };
    std::optional<Recorder> recorder;
    const auto record = [&](PlanSetup& setup) {
        if (limits.trace)
            recordInto(recorder.emplace(setup.si->getStateSpace(), *limits.trace), setup, scene, isOver);
    };
    const PlanSetup setup = planning::makePlanSetup(problem, scene, options, settings, isOver, record);
    BenchmarkRun run;
    const ob::PlannerStatus status =
        solve(setup, limits, end, recorder ? &*recorder : nullptr, run, warnings);
    const auto isStopped = [&] { return limits.isStopped && limits.isStopped(); };
    if (isStopped()) return std::nullopt;

    const double bytes = static_cast<double>(ompl::machine::getProcessMemoryUsage());
    run.isSolved = setup.definition->hasExactSolution();
    run.properties["memory REAL"] = shortNumber(bytes / kBytesPerMegabyte);
    run.properties["status ENUM"] =
        std::to_string(static_cast<int>(static_cast<ob::PlannerStatus::StatusType>(status)));
    run.properties["solved BOOLEAN"] = flag(run.isSolved);
    run.properties["seed INTEGER"] = std::to_string(options.seed);
    describeAnswers(setup, run.properties);
    describeGraph(setup, run.properties);
    if (setup.definition->hasSolution()) describeSolution(setup, limits, run);
    if (isStopped()) return std::nullopt;
    return run;
}

}  // namespace clearway::study
