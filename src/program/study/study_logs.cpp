#include "program/study/study_logs.h"

#include "core/replace_file.h"
#include "program/study/benchmark_log.h"
#include "program/study/engine.h"
#include "program/study/machine.h"
#include "program/study/planner_runs.h"
#include "program/study/study_rows.h"

namespace clearway::study {
namespace {

Benchmark experiment(const StudyProblem& problem, const StudyOptions& options, const Engine& engine) {
    Benchmark benchmark;
    benchmark.experiment = problem.name;
    benchmark.parameters = {{"general_split VARCHAR", engine.build.generalSplit},
                            {"leaf_split VARCHAR", engine.build.leafSplit},
                            {"leaf_size INTEGER", std::to_string(engine.build.leafSize)}};
    benchmark.cpu = processorName();
    benchmark.started = timeNow();
    benchmark.setup = "Problem: " + problem.problem.file + "\n";
    benchmark.options.seconds = options.seconds;
    benchmark.options.megabytes = options.megabytes;
    benchmark.options.runs = options.seeds;
    benchmark.isComplete = true;
    return benchmark;
}

}  // namespace

std::vector<std::string> writeStudyLogs(const StudyProblem& problem, const StudyOptions& options,
                                        const std::vector<TableRow>& runs, const std::string& folder) {
    makeFolder(folder + "/logs");
    std::vector<std::string> files;
    for (const EngineGroup& group : plannedGroups(options)) {
        for (const Engine& engine : group) {
            Benchmark benchmark = experiment(problem, options, engine);
            for (const StudyPlanner& planner : options.planners) {
                PlannerBenchmark of;
                of.name = "geometric_" + planner.name;
                if (!planner.objective.empty()) of.settings["objective"] = planner.objective;
                for (const TableRow& row : runs) {
                    if (row.at("scene") != problem.name || row.at("planner") != planner.name ||
                        row.at("general_split") != engine.build.generalSplit ||
                        row.at("leaf_split") != engine.build.leafSplit) {
                        continue;
                    }
                    of.runs.push_back({propertiesOf(row), {}, row.at("solved") == "1", 0, {}, {}});
                    benchmark.seconds += sumIn(row, {"seconds"});
                }
                benchmark.planners.push_back(of);
            }
            files.push_back(folder + "/logs/" + problem.name + "_" + engine.build.generalSplit + "_" +
                            engine.build.leafSplit + ".log");
            replaceFile(files.back(), [&](std::ostream& out) { writeBenchmarkLog(benchmark, out); });
        }
    }
    return files;
}

}  // namespace clearway::study
