// Measures speed against error: times several ways to measure a distance in one process. The oracle judges
// every pose.
//   benchmarks speed_error [--scenes F,K] [--out DIR] ...      see --help and README.md in this folder
// Ends with exit code 1 when an answer of clearway is wrong, and with 2 when the benchmark cannot run.
#include <filesystem>
#include <iostream>

#include "bench/error_report.h"
#include "bench/task_options.h"
#include "clearway/targets.h"

namespace clearway::testing::speed_error {

const std::vector<double> kMarginShares = {0, 1e-6, 1e-3};  // shares of the scene's size

struct ErrorChoices : TaskChoices {
    int nearBases = 20;
};

std::optional<ErrorChoices> readOptions(int count, char** words) {
    ErrorChoices choices;
    choices.scenes = allSceneNames();
    cli::CommandLine line("benchmarks speed_error [options]",
                          "Times the ways to answer \"how far?\" and has the oracle say their errors.");
    addTaskOptions(line, "speed_error.csv", choices);
    line.option("--near-bases N",
                "poses that are moved near to each margin, each to nine or thirteen distances (20)",
                cli::integer<int>(choices.nearBases, 0, INT32_MAX));
    if (!line.parse({words + 1, words + count})) return std::nullopt;
    return choices;
}

/// Times every mode; passes take turns.
void run(std::vector<Mode>& modes, const std::vector<Pose>& poses, const Schedule& schedule) {
    std::vector<Series> all;
    for (const Mode& mode : modes) all.push_back(mode.series);
    runAll(all, poses, schedule);
    for (std::size_t k = 0; k < modes.size(); ++k) modes[k].series = std::move(all[k]);
}

const Series& floatOnlyOf(const std::vector<Mode>& modes) {
    for (const Mode& mode : modes) {
        if (mode.name() == kFloatOnly) return mode.series;
    }
    throw std::logic_error("float only is no mode");
}

VerdictCounts verdictsOf(const Mode& mode, const PosesNearMargin& near) {
    if (mode.series.beforePass) mode.series.beforePass();
    VerdictCounts counts;
    for (std::size_t i = 0; i < near.poses.size(); ++i) {
        const bool saysValid = mode.isValid(near.poses[i], near.margin);
        counts.falseValid += saysValid && !near.isValid[i];
        counts.falseInvalid += !saysValid && near.isValid[i];
    }
    return counts;
}

ErrorReport measure(const BenchTask& task, const ErrorChoices& choices) {
    const TreePair trees = buildTrees(task, BuildOptions{});
    std::vector<Peer> peers;
    if (!choices.withoutPeers) peers = makePeers(task.part, task.environment);
    std::vector<Mode> modes = makeModes(task, trees, peers);
    run(modes, task.poses, choices.schedule);

    ErrorReport report{task.name, task.about, task.poses.size(), 0, {}, kMarginShares, {}};
    const MeshOracle oracle(task.part, task.environment);
    std::vector<Truth> truths;
    for (const Pose& pose : task.poses) {
        truths.push_back(askOracle(oracle, task, pose));
        report.colliding += truths.back().distance == 0;
    }
    for (const double share : kMarginShares) {
        report.margins.push_back(
            posesNearMargin(task, trees, oracle, truths, share * task.sceneSize(), choices.nearBases));
    }
    for (const Mode& mode : modes) {
        ModeFigures figures = figuresOf(mode, floatOnlyOf(modes), truths, task.sceneSize());
        for (const PosesNearMargin& near : report.margins) figures.verdicts.push_back(verdictsOf(mode, near));
        report.modes.push_back(std::move(figures));
    }
    return report;
}

int run(const ErrorChoices& choices) {
    if (!choices.out.empty()) std::filesystem::create_directories(choices.out);  // before what takes long
    std::cout << "best target " << currentTarget() << "; of each time, the clock takes " << clockNanoseconds()
              << " ns\n";
    std::string table = errorHeader(kMarginShares);
    std::cout << table;
    std::size_t wrong = 0;
    for (const std::string& name : choices.scenes) {
        const ErrorReport report = measure(makeTask(choices, name), choices);
        const std::string rows = errorRows(report);
        std::cout << rows;
        for (const std::string& fault : faults(report)) std::cout << "WRONG: " << fault << std::endl;
        wrong += faults(report).size();
        table += rows;
        writeTable(choices.out, "speed_error.csv", table);
    }
    return wrong == 0 ? 0 : 1;
}

int run(int count, char** words) {
    const auto choices = readOptions(count, words);
    return choices ? run(*choices) : 0;
}

}  // namespace clearway::testing::speed_error
