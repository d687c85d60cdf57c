#include "demos/study/files.h"

#include "core/clock.h"
#include "demos/study/statistics.h"
#include "program/bench/planner_run.h"

namespace clearway::study {
namespace {

constexpr double kMostSeconds = 30;  ///< after these, no further round of builds begins

FilesRow rowOf(const StudyProblem& problem, const Engine& engine) {
    FilesRow row;
    static_cast<Engine&>(row) = engine;
    row.scene = problem.name;
    return row;
}

/// Builds the row's trees of the part and of the obstacles, sets what they hold, and returns the seconds.
double build(const StudyProblem& problem, FilesRow& row) {
    row.triangles = row.leaves = 0;
    row.megabytes = 0;
    const BuildOptions options = row.build();
    double seconds = 0;
    const auto add = [&](const Mesh& mesh) {
        const Clock::time_point begin = Clock::now();
        const Model model = Model::build(mesh, options);
        seconds += secondsSince(begin);
        const BuildReport& report = model.report();
        row.triangles += report.triangles;
        row.leaves += report.tree.leaves;
        row.megabytes += static_cast<double>(report.tree.bytes) / kBytesPerMegabyte;
    };
    add(problem.part);
    for (const ObstacleGroup& group : problem.obstacles.groups) add(group.mesh);
    return seconds;
}

}  // namespace

Columns<FilesRow> filesColumns() {
    using Row = FilesRow;
    const Columns<Row> scene = {{"scene", &Row::scene}};
    const Columns<Row> rest = {{"load_seconds", &Row::loadSeconds},
                               {"build_seconds", &Row::buildSeconds},
                               {"triangles", &Row::triangles},
                               {"leaves", &Row::leaves},
                               {"megabytes", &Row::megabytes}};
    return scene + engineColumns<Row>() + rest;
}

std::optional<std::vector<FilesRow>> measureFiles(const std::function<StudyProblem()>& load,
                                                  const StudyOptions& options) {
    std::vector<double> loads;
    std::optional<StudyProblem> problem;
    for (int i = 0; i < options.loads; ++i) {
        if (options.mustStop()) return std::nullopt;
        problem.reset();
        const Clock::time_point begin = Clock::now();
        problem = load();
        loads.push_back(secondsSince(begin));
    }
    std::vector<FilesRow> rows;
    for (const Engine& engine : plannedEngines(options)) rows.push_back(rowOf(*problem, engine));
    build(*problem, rows.front());  // the first one in a process takes longer
    std::vector<std::vector<double>> builds(rows.size());
    const Clock::time_point begin = Clock::now();
    for (int i = 0; i < options.loads && (i == 0 || secondsSince(begin) < kMostSeconds); ++i) {
        for (std::size_t k = 0; k < rows.size(); ++k) {
            if (options.mustStop()) return std::nullopt;
            builds[k].push_back(build(*problem, rows[k]));
        }
    }
    for (std::size_t k = 0; k < rows.size(); ++k) {
        rows[k].loadSeconds = median(loads);
        rows[k].buildSeconds = median(builds[k]);
    }
    return rows;
}

}  // namespace clearway::study
