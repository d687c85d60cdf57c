// Compares the strategies that trees are built by: the time of each question over that with the default trees,
// and what the trees take to build.
//   benchmarks strategies [--scenes F,K] [--out DIR] ...      see --help and README.md in this folder
// Ends with exit code 1 when two strategies answer differently, and with 2 when the benchmark cannot run.
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <sstream>

#include "bench/clearway_series.h"
#include "bench/task_options.h"
#include "core/clock.h"

namespace clearway::testing::strategies {

constexpr double kAgreement = 1e-9;  // share of the scene's size

struct Strategy {
    std::string name;  ///< as options of the program: general split, leaf split
    BuildOptions options;
};

/// The default first, which the others are compared with; then each other general split, and each other leaf
/// split of the default.
std::vector<Strategy> strategies() {
    const BuildOptions usual;
    const auto named = [](const BuildOptions& options) {
        return Strategy{options.generalSplit + "/" + options.leafSplit, options};
    };
    std::vector<Strategy> all = {named(usual)};
    for (const std::string& split : generalSplitNames()) {
        BuildOptions options;
        options.generalSplit = split;
        if (split != usual.generalSplit) all.push_back(named(options));
    }
    for (const std::string& split : leafSplitNames()) {
        BuildOptions options;
        options.leafSplit = split;
        if (split != usual.leafSplit) all.push_back(named(options));
    }
    return all;
}

struct Built {
    TreePair trees;
    double seconds = 0;
    double bytesPerTriangle = 0;
};

Built build(const BenchTask& task, const BuildOptions& options) {
    const auto begin = Clock::now();
    const TreePair trees = buildTrees(task, options);
    const double seconds = secondsSince(begin);
    const auto bytes =
        static_cast<double>(trees.part.report().tree.bytes + trees.environment.report().tree.bytes);
    const auto triangles =
        static_cast<double>(trees.part.report().triangles + trees.environment.report().triangles);
    return {trees, seconds, bytes / triangles};
}

/// The poses at which two series for one question differ.
std::size_t differences(const Series& a, const Series& b, double tolerance) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.answers.size(); ++i) {
        count += std::abs(a.answers[i].value - b.answers[i].value) > tolerance;
    }
    return count;
}

/// Prints a scene's rows and appends them to the table. Returns the number of answers that differ.
std::size_t measure(const BenchTask& task, const Schedule& schedule, std::string& table) {
    std::vector<Built> built;
    std::vector<Series> all;
    const std::vector<Strategy> tried = strategies();
    for (const Strategy& strategy : tried) {
        built.push_back(build(task, strategy.options));
        for (Series& series : seriesOfTrees(task, built.back().trees, strategy.name)) all.push_back(series);
    }
    runAll(all, task.poses, schedule);
    const std::size_t questions = all.size() / tried.size();
    std::size_t different = 0;
    std::ostringstream rows;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Series& usual = all[i % questions];
        const Built& trees = built[i / questions];
        different += differences(all[i], usual, kAgreement * task.sceneSize());
        std::vector<double> over = ratios(usual, all[i]);
        std::sort(over.begin(), over.end());
        rows << std::setprecision(6) << task.name << ',' << task.sceneName << ','
             << task.part.triangles.size() << ',' << task.environment.triangles.size() << ',' << all[i].asked
             << ',' << all[i].engine << ',' << mean(all[i].medians()) / 1000 << ',' << median(over) << ','
             << over.front() << ',' << over.back() << ',' << over.size() << ',' << trees.seconds << ','
             << trees.bytesPerTriangle << '\n';
    }
    std::cout << rows.str() << std::flush;
    table += rows.str();
    if (different > 0) std::cout << task.name << ": " << different << " answers differ\n";
    return different;
}

int run(int count, char** words) {
    TaskChoices choices;
    choices.scenes = allSceneNames();
    cli::CommandLine line("benchmarks strategies [options]",
                          "Times every question with trees built by every strategy, in turns.");
    addTaskOptions(line, "strategies.csv", choices);
    addFileOptions(line, choices);
    if (!line.parse({words + 1, words + count})) return 0;
    requireFiles(choices);
    std::string table =
        "scene,scene_name,part_triangles,environment_triangles,question,strategy,us_mean,over_default,"
        "over_default_least,over_default_largest,repetitions,build_seconds,bytes_per_triangle\n";
    std::cout << table;
    std::size_t different = 0;
    if (choices.scenes.empty()) different += measure(taskFromFiles(choices), choices.schedule, table);
    for (const std::string& scene : choices.scenes) {
        different += measure(makeTask(choices, scene), choices.schedule, table);
    }
    writeTable(choices.out, "strategies.csv", table);
    return different == 0 ? 0 : 1;
}

}  // namespace clearway::testing::strategies
