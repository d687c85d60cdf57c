#include "demos/study/planner_runs.h"

#include <fmt/format.h>
#include <ompl/util/Time.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <ostream>
#include <set>
#include <stdexcept>
#include <tuple>

#include "clearway/planning/ompl_messages.h"
#include "clearway/planning/planners.h"
#include "clearway/targets.h"
#include "core/replace_file.h"
#include "demos/study/recorder.h"
#include "program/bench/benchmark.h"
#include "program/bench/benchmark_log.h"

namespace clearway::study {
namespace {

constexpr double kLeastShare = 0.95;  ///< of a processor, for an undisturbed run

std::vector<Engine> allEngines(const StudyOptions& options) {
    std::vector<Engine> engines;
    for (const EngineGroup& group : plannedGroups(options))
        engines.insert(engines.end(), group.begin(), group.end());
    return engines;
}

RunRow rowOf(const std::string& scene, const PlannedRun& run) {
    RunRow row;
    static_cast<Engine&>(row) = run.engine;
    row.scene = scene;
    row.planner = run.planner.name;
    row.seed = run.seed;
    return row;
}

auto keyOf(const RunRow& row) {
    return std::tie(row.scene, row.planner, row.generalSplit, row.leafSplit, row.seed);
}

/// Throws when the table has a run twice, because the run would count twice. Two programs at once may have
/// written it, or a user's edit.
void requireOnce(const GrowingTable<RunRow>& runs) {
    std::set<std::decay_t<decltype(keyOf(runs.rows().front()))>> seen;
    for (const RunRow& row : runs.rows()) {
        if (seen.insert(keyOf(row)).second) continue;
        throw std::runtime_error(fmt::format("{} has the run of {} {} seed {} in {} twice, expected once",
                                             runs.file(), row.planner, row.name(), row.seed, row.scene));
    }
}

/// The problem with this planner alone, and with the parameters that the problem has for it.
Problem problemFor(const Problem& stated, const StudyPlanner& planner) {
    Problem problem = stated;
    problem.planning.planners.clear();
    for (const PlannerChoice& choice : stated.planning.planners) {
        if (planning::plannerClassName(choice.name) == planner.name) problem.planning.planners = {choice};
    }
    if (problem.planning.planners.empty()) problem.planning.planners = {{planner.name}};
    problem.planning.objective = "length";
    problem.planning.objectiveThreshold.reset();
    return problem;
}

Benchmark experiment(const StudyProblem& problem, const StudyOptions& options, const Engine& engine) {
    Benchmark benchmark;
    benchmark.experiment = problem.name;
    benchmark.parameters = {{"general_split VARCHAR", engine.generalSplit},
                            {"leaf_split VARCHAR", engine.leafSplit},
                            {"leaf_size INTEGER", std::to_string(engine.leafSize)}};
    benchmark.cpu = processorName();
    benchmark.started = ompl::time::as_string(ompl::time::now());
    benchmark.setup = "Problem: " + problem.problem.file + "\n";
    benchmark.options.seconds = options.seconds;
    benchmark.options.megabytes = options.megabytes;
    benchmark.options.runs = options.seeds;
    return benchmark;
}

}  // namespace

double RunRow::calls() const {
    double sum = 0;
    for (const Count& count : {stateChecks, motionChecks, motionCosts})
        sum += static_cast<double>(count.value_or(0));
    return sum;
}

Measure RunRow::firstSolution() const {
    return isSolved == 1u ? firstSolutionSeconds : std::nullopt;
}

Measure RunRow::finiteCost() const {
    return isSolved == 1u && cost && std::isfinite(*cost) ? cost : std::nullopt;
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

std::string callsFile(const std::string& folder, const std::string& scene, const std::string& planner,
                      int seed) {
    return fmt::format("{}/calls/{}_{}_{}.calls", folder, scene, planner, seed);
}

std::string PlannedRun::name() const {
    return fmt::format("{} {} seed {}", planner.name, engine.name(), seed);
}

/// Runs all strategies back to back for each seed and planner, rotating which goes first, so that slow drifts
/// of the machine affect them equally.
std::vector<PlannedRun> plannedRuns(const StudyOptions& options) {
    const std::vector<Engine> engines = allEngines(options);
    std::vector<PlannedRun> runs;
    for (int seed = 1; seed <= options.seeds; ++seed) {
        for (const StudyPlanner& planner : options.planners) {
            for (std::size_t i = 0; i < engines.size(); ++i) {
                const std::size_t strategy = (i + static_cast<std::size_t>(seed - 1)) % engines.size();
                runs.push_back({planner, engines[strategy], strategy, seed, /*keepsCalls*/ i == 0});
            }
        }
    }
    return runs;
}

std::optional<StudyRun> runPlanned(const StudyProblem& problem, const Scene& scene,
                                   const StudyOptions& options, const PlannedRun& planned) {
    planning::PlanOptions plan;
    plan.seconds = options.seconds;
    plan.threads = 1;
    plan.seed = static_cast<std::uint32_t>(planned.seed);
    plan.objective = planned.planner.objective;
    RunLimits limits;
    limits.seconds = options.seconds;
    limits.bytes = static_cast<unsigned long long>(options.megabytes * 1024 * 1024);
    limits.simplify = false;
    limits.isStopped = options.isStopped;
    CallSampling sampling = options.sampling;
    sampling.seed = static_cast<std::uint64_t>(planned.seed);
    std::optional<Recorder> recorder;
    limits.watch = recordingInto(recorder, sampling);
    const planning::OmplMessages unobserved;
    StudyRun result;
    const auto run =
        runOnce(problemFor(problem.problem, planned.planner), scene, plan, limits, result.warnings);
    if (!run) return std::nullopt;
    result.row = rowOf(problem.name, planned);
    static_cast<RunMeasures&>(result.row) = run->measures;
    if (planned.keepsCalls) result.calls = callsText(recorder->sample());
    result.machine = machineName();
    return result;
}

void keepRun(const StudyRun& run, const StudyOptions& options, const std::string& folder,
             GrowingTable<RunRow>& runs) {
    for (const std::string& warning : run.warnings) options.report("warning: " + warning);
    const RunRow& row = run.row;
    if (run.machine != machineName()) {
        throw std::runtime_error(fmt::format(
            "the run of {} {} seed {} was done by {}, expected {} as for the study's other runs, whose "
            "times it is compared with",
            row.planner, row.name(), row.seed, run.machine, machineName()));
    }
    if (run.calls) writeCalls(*run.calls, callsFile(folder, row.scene, row.planner, row.seed));
    runs.append({row});
}

std::vector<std::size_t> missingRuns(const StudyProblem& problem, std::size_t position,
                                     const StudyOptions& options, const GrowingTable<RunRow>& runs) {
    requireOnce(runs);
    const std::vector<PlannedRun> planned = plannedRuns(options);
    std::vector<std::size_t> missing;
    for (std::size_t i = 0; i < planned.size(); ++i) {
        const RunRow wanted = rowOf(problem.name, planned[i]);
        const bool isDone = std::any_of(runs.rows().begin(), runs.rows().end(),
                                        [&](const RunRow& row) { return keyOf(row) == keyOf(wanted); });
        if (!isDone) missing.push_back(position * planned.size() + i);
    }
    return missing;
}

bool runPlanners(const StudyProblem& problem, const StudyOptions& options, const std::string& folder,
                 GrowingTable<RunRow>& runs) {
    makeFolder(folder + "/calls");
    const std::vector<PlannedRun> planned = plannedRuns(options);
    const std::vector<std::size_t> missing = missingRuns(problem, 0, options, runs);
    std::map<std::size_t, Scene> scenes;  // by strategy, built when first needed
    TimeLeft left(missing.size(), options.seconds);
    for (const std::size_t number : missing) {
        const PlannedRun& run = planned[number];
        if (options.mustStop()) return false;
        options.report(fmt::format("{}: run {} of {}, {}, {} for its runs", problem.name, left.done() + 1,
                                   left.all(), run.name(), left.text()));
        auto scene = scenes.find(run.strategy);
        if (scene == scenes.end())
            scene = scenes.emplace(run.strategy, buildScene(problem, run.engine, options)).first;
        const auto done = runPlanned(problem, scene->second, options, run);
        if (!done) return false;
        keepRun(*done, options, folder, runs);
        left.step();
    }
    return true;
}

void writeStudyLogs(const StudyProblem& problem, const StudyOptions& options, const std::vector<RunRow>& runs,
                    const std::string& folder) {
    makeFolder(folder + "/logs");
    for (const Engine& engine : allEngines(options)) {
        Benchmark benchmark = experiment(problem, options, engine);
        for (const StudyPlanner& planner : options.planners) {
            PlannerBenchmark of;
            of.name = "geometric_" + planner.name;
            if (!planner.objective.empty()) of.settings["objective"] = planner.objective;
            for (const RunRow& row : runs) {
                if (row.scene != problem.name || row.planner != planner.name || !(row == engine)) continue;
                BenchmarkRun& run = of.runs.emplace_back();
                run.properties = propertiesOf(row);
                run.properties["seed INTEGER"] = std::to_string(row.seed);
                benchmark.seconds += row.seconds.value_or(0);
            }
            benchmark.planners.push_back(of);
        }
        replaceFile(
            folder + "/logs/" + problem.name + "_" + engine.generalSplit + "_" + engine.leafSplit + ".log",
            [&](std::ostream& out) { writeBenchmarkLog(benchmark, out); });
    }
}

std::string machineName() {
    return processorName() + ", " + availableTargets().front();
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
