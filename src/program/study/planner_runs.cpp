#include "program/study/planner_runs.h"

#include <chrono>
#include <set>
#include <stdexcept>

#include "clearway/planning/ompl_messages.h"
#include "clearway/planning/planners.h"
#include "core/replace_file.h"
#include "program/study/benchmark_run.h"
#include "program/study/call_file.h"
#include "program/study/time_left.h"

namespace clearway::study {
namespace {

struct RunColumn {
    const char* name;
    const char* property;  ///< OMPL's name in logs, or the benchmark's own
};

constexpr RunColumn kRunColumns[] = {
    {"solved", "solved BOOLEAN"},
    {"status", "status ENUM"},
    {"seconds", "time REAL"},
    {"processor_seconds", "processor time REAL"},  // less than the time: the machine was at other work
    {"first_solution_seconds", "time to first solution REAL"},
    {"final_solution_seconds", "time to final solution REAL"},
    {"cost", "solution cost REAL"},
    {"length", "solution length REAL"},
    {"least_clearance", "least clearance REAL"},
    {"certified", "correct solution strict BOOLEAN"},
    {"state_checks", "state checks INTEGER"},
    {"motion_checks", "motion checks INTEGER"},
    {"motion_costs", "motion costs INTEGER"},
    {"undecided_motions", "undecided motions INTEGER"},
    {"distance_queries", "distance queries INTEGER"},
    {"within_queries", "within queries INTEGER"},
    {"query_seconds", "query time REAL"},
    {"query_share", "query share REAL"},
    {"volume_tests", "volume tests INTEGER"},
    {"triangle_tests", "triangle tests INTEGER"},
    {"triangle_lanes", "triangle lanes INTEGER"},
    {"kernel_pairs", "kernel pairs INTEGER"},
    {"kernel_lanes", "kernel lanes INTEGER"},
    {"graph_states", "graph states INTEGER"},
    {"graph_motions", "graph motions INTEGER"},
    {"megabytes", "memory REAL"},
};

struct PlannedRun {
    StudyPlanner planner;
    Engine engine;
    std::size_t strategy = 0;  ///< position among all engines
    int seed = 1;
};

std::vector<Engine> allEngines(const StudyOptions& options) {
    std::vector<Engine> engines;
    for (const EngineGroup& group : plannedGroups(options))
        engines.insert(engines.end(), group.begin(), group.end());
    return engines;
}

/// Of each seed and planner the strategies follow each other, a later one first with each seed: what changes
/// in the machine with time then falls on all of them alike.
std::vector<PlannedRun> schedule(const StudyOptions& options) {
    const std::vector<Engine> engines = allEngines(options);
    std::vector<PlannedRun> runs;
    for (int seed = 1; seed <= options.seeds; ++seed) {
        for (const StudyPlanner& planner : options.planners) {
            for (std::size_t i = 0; i < engines.size(); ++i) {
                const std::size_t strategy = (i + static_cast<std::size_t>(seed - 1)) % engines.size();
                runs.push_back({planner, engines[strategy], strategy, seed});
            }
        }
    }
    return runs;
}

TableRow keyOf(const std::string& scene, const PlannedRun& run) {
    return {{"scene", scene},
            {"planner", run.planner.name},
            {"general_split", run.engine.build.generalSplit},
            {"leaf_split", run.engine.build.leafSplit},
            {"seed", std::to_string(run.seed)}};
}

bool isDone(const GrowingTable& runs, const TableRow& key) {
    for (const TableRow& row : runs.rows()) {
        bool isSame = true;
        for (const auto& [column, value] : key) isSame = isSame && row.at(column) == value;
        if (isSame) return true;
    }
    return false;
}

/// Two programs at once, or a hand, may have left a run twice; it would count twice.
void requireOnce(const GrowingTable& runs) {
    std::set<std::vector<std::string>> seen;
    for (const TableRow& row : runs.rows()) {
        const std::vector<std::string> key = {row.at("scene"), row.at("planner"), row.at("general_split"),
                                              row.at("leaf_split"), row.at("seed")};
        if (seen.insert(key).second) continue;
        throw std::runtime_error(runs.file() + " has the run of " + key[1] + " " + key[2] + "/" + key[3] +
                                 " seed " + key[4] + " in " + key[0] + " twice, expected once");
    }
}

/// The problem with that planner alone, and its parameters if the problem has some.
Problem problemFor(const Problem& stated, const StudyPlanner& planner) {
    Problem problem = stated;
    problem.planners.clear();
    for (const PlannerChoice& choice : stated.planners) {
        if (planning::plannerClassName(choice.name) == planner.name) problem.planners = {choice};
    }
    if (problem.planners.empty()) problem.planners = {{planner.name}};
    problem.objective = "length";
    problem.objectiveThreshold.reset();
    return problem;
}

class Runner {
  public:
    Runner(const StudyProblem& problem, const StudyOptions& options, const std::string& folder,
           GrowingTable& runs)
        : problem_(problem),
          options_(options),
          folder_(folder),
          runs_(runs),
          strategies_(allEngines(options).size()) {}

    bool runAll(const std::vector<PlannedRun>& planned) {
        TimeLeft left(planned.size(), options_.seconds);
        for (std::size_t i = 0; i < planned.size(); ++i) {
            if (options_.isStopped && options_.isStopped()) return false;
            const PlannedRun& run = planned[i];
            if (options_.tell) {
                options_.tell(problem_.name + ": run " + std::to_string(left.done() + 1) + " of " +
                              std::to_string(left.all()) + ", " + run.planner.name + " " +
                              nameOf(run.engine) + " seed " + std::to_string(run.seed) + ", " + left.text() +
                              " for its runs");
            }
            if (!runOnce(run)) return false;
            left.step();
        }
        return true;
    }

  private:
    const Scene& sceneOf(const PlannedRun& run) {
        if (scenes_.empty()) scenes_.resize(strategies_);
        auto& scene = scenes_[run.strategy];
        if (!scene) scene = std::make_unique<Scene>(buildScene(problem_, run.engine, options_.cache));
        return *scene;
    }

    bool runOnce(const PlannedRun& planned) {
        planning::PlanOptions options;
        options.seconds = options_.seconds;
        options.threads = 1;
        options.seed = static_cast<std::uint32_t>(planned.seed);
        options.objective = planned.planner.objective;
        RunLimits limits;
        limits.seconds = options_.seconds;
        limits.bytes = static_cast<unsigned long long>(options_.megabytes * 1024 * 1024);
        limits.simplify = false;
        limits.isStopped = options_.isStopped;
        limits.trace = options_.sampling;
        limits.trace->seed = static_cast<std::uint64_t>(planned.seed);
        const planning::OmplMessages unheard;
        std::vector<std::string> warnings;
        const auto run = study::runOnce(problemFor(problem_.problem, planned.planner), sceneOf(planned),
                                        options, limits, warnings);
        if (options_.tell) {
            for (const std::string& warning : warnings) options_.tell("warning: " + warning);
        }
        if (!run) return false;
        keep(planned, *run);
        return true;
    }

    /// The sample goes first: a run in the table has its sample.
    void keep(const PlannedRun& planned, const BenchmarkRun& run) {
        if (planned.strategy == static_cast<std::size_t>(planned.seed - 1) % strategies_) {
            writeCalls(run.calls, callsFile(folder_, problem_.name, planned.planner.name, planned.seed));
        }
        TableRow row = keyOf(problem_.name, planned);
        for (const RunColumn& column : kRunColumns) {
            const auto found = run.properties.find(column.property);
            if (found != run.properties.end()) row[column.name] = found->second;
        }
        runs_.append({row});
    }

    const StudyProblem& problem_;
    const StudyOptions& options_;
    std::string folder_;
    GrowingTable& runs_;
    std::size_t strategies_;
    std::vector<std::unique_ptr<Scene>> scenes_;  ///< of each strategy, when it was needed
};

}  // namespace

std::vector<std::string> runColumns() {
    std::vector<std::string> columns = {"scene", "planner", "general_split", "leaf_split", "seed"};
    for (const RunColumn& column : kRunColumns) columns.push_back(column.name);
    return columns;
}

Properties propertiesOf(const TableRow& run) {
    Properties properties = {{"seed INTEGER", run.at("seed")}};
    for (const RunColumn& column : kRunColumns) {
        const std::string& value = run.at(column.name);
        if (!value.empty()) properties[column.property] = value;
    }
    return properties;
}

std::string callsFile(const std::string& folder, const std::string& scene, const std::string& planner,
                      int seed) {
    return folder + "/calls/" + scene + "_" + planner + "_" + std::to_string(seed) + ".calls";
}

bool runPlanners(const StudyProblem& problem, const StudyOptions& options, const std::string& folder,
                 GrowingTable& runs) {
    requireOnce(runs);
    makeFolder(folder + "/calls");
    std::vector<PlannedRun> left;
    for (const PlannedRun& run : schedule(options)) {
        if (!isDone(runs, keyOf(problem.name, run))) left.push_back(run);
    }
    return Runner(problem, options, folder, runs).runAll(left);
}

}  // namespace clearway::study
