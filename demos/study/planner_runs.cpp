#include "demos/study/planner_runs.h"

#include <fmt/format.h>

#include <fstream>
#include <set>

#include "clearway/planning/ompl_messages.h"
#include "clearway/planning/planners.h"
#include "demos/study/recorder.h"

namespace clearway::study {
namespace {

constexpr double kLeastShare = 0.95;  ///< of a processor, for an undisturbed run

/// These planners also ask the scene itself.
const std::set<std::string> kOwnPlanners = {"SlidingRRTConnect", "TwistSearch", "RisingFloor"};

/// The problem with this planner alone, and with the parameters that the problem has for it.
Problem problemFor(const Problem& stated, const std::string& planner) {
    Problem problem = stated;
    problem.planning.planners.clear();
    for (const PlannerChoice& choice : stated.planning.planners) {
        if (planning::plannerClassName(choice.name) == planner) problem.planning.planners = {choice};
    }
    if (problem.planning.planners.empty()) problem.planning.planners = {{planner}};
    problem.planning.objective = "length";
    problem.planning.objectiveThreshold.reset();
    return problem;
}

}  // namespace

Measure RunRow::calls() const {
    double sum = 0;
    for (const Count& count : {stateChecks, motionChecks}) sum += static_cast<double>(count.value_or(0));
    return queries() > 0 && kOwnPlanners.count(planner) == 0 ? Measure(sum) : std::nullopt;
}

bool RunRow::wasDisturbed() const {
    return processorSeconds && seconds && *processorSeconds < kLeastShare * *seconds;
}

Columns<RunRow> runColumns() {
    Columns<RunRow> columns = {{"scene", &RunRow::scene},
                               {"planner", &RunRow::planner},
                               {"general_split", &RunRow::generalSplit},
                               {"leaf_split", &RunRow::leafSplit},
                               {"seed", &RunRow::seed}};
    for (const RunProperty& each : runProperties()) {
        std::visit([&](auto member) { columns.push_back({each.column, member}); }, each.member);
    }
    return columns;
}

std::string PlannedRun::name() const {
    return fmt::format("{} {} seed {}", planner, engine.name(), seed);
}

std::optional<StudyRun> runPlanned(const StudyProblem& problem, const Scene& scene,
                                   const StudyOptions& options, const PlannedRun& planned,
                                   bool samplesCalls) {
    planning::PlanOptions plan;
    plan.seconds = planned.seconds;
    plan.threads = 1;
    plan.seed = static_cast<std::uint32_t>(planned.seed);
    RunLimits limits;
    limits.seconds = planned.seconds;
    limits.bytes = static_cast<unsigned long long>(options.megabytes * kBytesPerMegabyte);
    limits.simplify = false;
    limits.endsAtFirstPath = true;
    limits.isStopped = options.isStopped;
    CallSampling sampling = options.sampling;
    sampling.seed = static_cast<std::uint64_t>(planned.seed);
    if (!samplesCalls) sampling.blocks = 0;
    std::optional<Recorder> recorder;
    limits.watch = recordingInto(recorder, sampling);
    const planning::OmplMessages unobserved;
    StudyRun result;
    const auto run =
        runOnce(problemFor(problem.problem, planned.planner), scene, plan, limits, result.warnings);
    if (!run) return std::nullopt;
    static_cast<Engine&>(result.row) = planned.engine;
    result.row.scene = problem.name;
    result.row.planner = planned.planner;
    result.row.seed = planned.seed;
    static_cast<RunMeasures&>(result.row) = run->measures;
    if (samplesCalls) result.calls = recorder->sample();
    return result;
}

std::string processorName() {
    std::ifstream in("/proc/cpuinfo");
    for (std::string line; std::getline(in, line);) {
        const std::size_t colon = line.find(": ");
        if (line.compare(0, 10, "model name") == 0 && colon != std::string::npos)
            return line.substr(colon + 2);
    }
    return "unknown";
}

}  // namespace clearway::study
