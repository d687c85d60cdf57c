// Measures every kind of query of clearway and of its peers, on equal meshes and poses, in one process, in
// turns.
//   benchmarks queries [--scenes F,K] [--out DIR] ...      see --help and README.md in this folder
// Ends with exit code 1 when an answer of clearway is wrong, and with 2 when the benchmark cannot run.
#include <filesystem>
#include <iostream>
#include <set>

#include "bench/bench_options.h"
#include "bench/bench_report.h"
#include "bench/benchmarks.h"
#include "clearway/targets.h"
#include "core/replace_file.h"

namespace clearway::testing::queries {
namespace {

constexpr double kAgreement = 1e-9;  // share of the scene's size

/// The text of the CSV files, for the scenes measured so far.
struct Tables {
    std::string summary = summaryHeader();
    std::string builds = buildsHeader();
};

void write(const std::string& folder, const std::string& name, const std::string& text) {
    replaceFile((std::filesystem::path(folder) / name).string(), [&](std::ostream& out) { out << text; });
}

void writeTables(const BenchChoices& choices, const BenchReport& report, Tables& tables) {
    const std::string summary = summaryRows(report), builds = buildsRows(report);
    std::cout << summaryHeader() << summary << buildsHeader() << builds << std::flush;
    for (const std::string& complaint : report.judgement.complaints)
        std::cout << "WRONG: " << complaint << std::endl;
    tables.summary += summary;
    tables.builds += builds;
    if (choices.out.empty()) return;
    write(choices.out, "poses_" + report.task.name + ".csv", posesTable(report));
    write(choices.out, "summary.csv", tables.summary);
    write(choices.out, "builds.csv", tables.builds);
}

/// Returns the number of clearway's wrong answers.
std::size_t measure(const BenchTask& task, const BenchChoices& choices, bool withBuilds, Tables& tables) {
    std::vector<BuildRow> builds;
    if (withBuilds) builds = measureBuilds(task, choices.trees, choices.builds);
    std::vector<Peer> peers;
    if (!choices.withoutPeers) peers = makePeers(task.part, task.environment);
    if (withBuilds) {
        for (const BuildRow& row : buildsOf(peers, task)) builds.push_back(row);
    }
    std::vector<Series> all =
        allSeries(task, buildTrees(task, choices.trees), peers, {choices.targets, choices.seed});
    runAll(all, task.poses, choices.schedule);
    useTarget("best");
    const Judgement judgement =
        judge(all, task.poses.size(), kAgreement * task.sceneSize(), lazyOracle(task), choices.oraclePoses);
    const BenchReport report{task, all, judgement, builds};
    writeTables(choices, report, tables);
    return judgement.complaints.size();
}

int run(const BenchChoices& choices) {
    if (!choices.out.empty()) std::filesystem::create_directories(choices.out);
    const BuildOptions& trees = choices.trees;
    std::cout << "trees: " << trees.generalSplit << ", fitted by " << trees.fit << ", leaves of up to "
              << trees.leafSize << " split by " << trees.leafSplit << ", " << trees.nodeWidth
              << " wide; best target " << currentTarget() << "; of each time, the clock takes "
              << clockNanoseconds() << " ns\n";
    Tables tables;
    std::size_t wrong = 0;
    if (choices.scenes.empty()) {
        wrong += measure(taskFromFiles(choices), choices, choices.builds.rounds > 0, tables);
    }
    std::set<std::string> built;  // two pose sets of one scene share its builds
    for (const std::string& name : choices.scenes) {
        const bool isNew = built.insert(benchSceneNamed(name).scene).second;
        const BenchTask task = makeTask(choices, name);
        wrong += measure(task, choices, isNew && choices.builds.rounds > 0, tables);
    }
    return wrong == 0 ? 0 : 1;
}

}  // namespace

int run(int count, char** words) {
    const auto choices = readOptions(count, words);
    return choices ? run(*choices) : 0;
}

}  // namespace clearway::testing::queries
