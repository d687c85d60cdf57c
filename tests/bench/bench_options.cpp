#include "bench/bench_options.h"

#include <algorithm>
#include <iostream>

#include "clearway/targets.h"
#include "program/options/shared_options.h"

namespace clearway::testing {

using cli::integer, cli::nonNegative, cli::to;

namespace {

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

}  // namespace

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

}  // namespace clearway::testing
