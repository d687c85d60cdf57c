// Measures every kind of query of clearway and of its peers, on equal meshes and poses, in one process, in
// turns.
//   benchmarks queries [--scenes F,K] [--out DIR] ...      see --help and README.md in this folder
// Ends with exit code 1 when an answer of clearway is wrong, and with 2 when the benchmark cannot run.
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <optional>
#include <set>

#include "bench/bench_report.h"
#include "bench/task_options.h"
#include "clearway/targets.h"
#include "program/options/shared_options.h"

namespace clearway::testing::queries {

using cli::integer, cli::nonNegative, cli::to;

constexpr double kAgreement = 1e-9;  // share of the scene's size

struct BenchChoices : TaskChoices {
    BuildSchedule builds;
    std::vector<std::string> targets;  ///< instruction sets besides the best one
    BuildOptions trees;
    std::size_t oraclePoses = 3;
};

/// The requested instruction sets that this machine and build have, without the best one, which is timed always.
std::vector<std::string> targetsOf(const std::string& targets) {
    std::vector<std::string> chosen;
    const std::vector<std::string> available = availableTargets();
    for (const std::string& target : targets == "all" ? available : splitAtCommas(targets)) {
        const bool isThere = std::find(available.begin(), available.end(), target) != available.end();
        if (!isThere) std::cout << "this machine or build has no " << target << ": its row is left out\n";
        if (isThere && target != available.front()) chosen.push_back(target);
    }
    return chosen;
}

/// Prints the help and returns nothing when it is asked for. Throws std::invalid_argument that names a wrong
/// option, its value and what was expected.
std::optional<BenchChoices> readOptions(int count, char** words) {
    BenchChoices choices;
    choices.scenes = allSceneNames();
    std::string targets = "avx2";
    cli::CommandLine line(
        "benchmarks queries [options]",
        "Times every kind of query of clearway and of its peers on the same meshes and poses.");
    addTaskOptions(line, "summary.csv, builds.csv and poses_SCENE.csv", choices);
    addFileOptions(line, choices);
    line.option("--build-rounds N", "rounds of builds; 0: none (5)",
                integer<int>(choices.builds.rounds, 0, INT32_MAX));
    line.option("--build-budget S", "seconds for a scene's builds (60)", nonNegative(choices.builds.seconds));
    line.option("--targets NAMES", "instruction sets timed besides the best one, or 'all' (avx2)",
                to(targets));
    cli::addTreeOptions(line, choices.trees);
    line.option("--oracle-poses N", "poses the oracle is asked about even if all agree (3)",
                integer<std::size_t>(choices.oraclePoses, 0, INT32_MAX));
    if (!line.parse({words + 1, words + count})) return std::nullopt;
    requireFiles(choices);
    choices.targets = targetsOf(targets);
    return choices;
}

/// The text of the CSV files, for the scenes measured so far.
struct Tables {
    std::string summary = summaryHeader();
    std::string builds = buildsHeader();
};

void writeTables(const BenchChoices& choices, const BenchReport& report, Tables& tables) {
    const std::string summary = summaryRows(report), builds = buildsRows(report);
    std::cout << summaryHeader() << summary << buildsHeader() << builds << std::flush;
    for (const std::string& complaint : report.judgement.complaints)
        std::cout << "WRONG: " << complaint << std::endl;
    tables.summary += summary;
    tables.builds += builds;
    if (choices.out.empty()) return;
    writeTable(choices.out, "poses_" + report.task.name + ".csv", posesTable(report));
    writeTable(choices.out, "summary.csv", tables.summary);
    writeTable(choices.out, "builds.csv", tables.builds);
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

int run(int count, char** words) {
    const auto choices = readOptions(count, words);
    return choices ? run(*choices) : 0;
}

}  // namespace clearway::testing::queries
