#include "bench/bench_options.h"

#include <algorithm>
#include <boost/program_options.hpp>
#include <iostream>
#include <stdexcept>

#include "clearway/targets.h"

namespace clearway::testing {
namespace {

namespace options = boost::program_options;

options::options_description allOptions() {
    options::options_description all("options");
    addTaskOptions(all, allSceneNames(), "summary.csv, builds.csv and poses_SCENE.csv");
    auto add = all.add_options();
    const auto text = [](const std::string& value) {
        return options::value<std::string>()->default_value(value);
    };
    add("part", options::value<std::string>(),
        "mesh file, instead of scenes; needs --environment and --poses");
    add("environment", options::value<std::string>(), "mesh file");
    add("poses", options::value<std::string>(), "poses file");
    add("build-rounds", options::value<int>()->default_value(5), "rounds of builds; 0: none");
    add("build-budget", options::value<double>()->default_value(60), "seconds for a scene's builds");
    add("targets", text("avx2"), "instruction sets to time besides the best one, or 'all'");
    add("preset", text("best"), "preset of build options; the options below change single ones");
    add("general-split", options::value<std::string>(), "general split, instead of the preset's");
    add("leaf-split", options::value<std::string>(), "leaf split, instead of the preset's");
    add("leaf-size", options::value<int>(), "leaf size, instead of the preset's");
    add("node-width", options::value<int>(), "node width, instead of the preset's");
    add("fit", options::value<std::string>(), "fit of the volumes, instead of the preset's");
    add("oracle-poses", options::value<int>()->default_value(3),
        "poses that the oracle decides although all answers agree");
    return all;
}

BuildOptions treeOptions(const options::variables_map& given) {
    BuildOptions build = buildPreset(given["preset"].as<std::string>());
    if (given.count("general-split") != 0) build.generalSplit = given["general-split"].as<std::string>();
    if (given.count("leaf-split") != 0) build.leafSplit = given["leaf-split"].as<std::string>();
    if (given.count("leaf-size") != 0) build.leafSize = given["leaf-size"].as<int>();
    if (given.count("node-width") != 0) build.nodeWidth = given["node-width"].as<int>();
    if (given.count("fit") != 0) build.fit = given["fit"].as<std::string>();
    requireBuildOptions(build);
    return build;
}

/// The requested instruction sets that this machine and build have.
std::vector<std::string> targetsOf(const options::variables_map& given) {
    std::vector<std::string> chosen;
    const std::string targets = given["targets"].as<std::string>();
    const std::vector<std::string> available = availableTargets();
    for (const std::string& target : targets == "all" ? available : splitAtCommas(targets)) {
        const bool isThere = std::find(available.begin(), available.end(), target) != available.end();
        if (!isThere) std::cout << "this machine or build has no " << target << ", so its row is left out\n";
        if (isThere) chosen.push_back(target);
    }
    return chosen;
}

template <typename Value>
std::optional<Value> given(const options::variables_map& all, const char* name) {
    if (all.count(name) == 0) return std::nullopt;
    return all[name].as<Value>();
}

BenchChoices choicesOf(const options::variables_map& all) {
    BenchChoices choices;
    static_cast<TaskChoices&>(choices) = taskChoices(all);
    choices.part = given<std::string>(all, "part").value_or("");
    choices.environment = given<std::string>(all, "environment").value_or("");
    choices.poses = given<std::string>(all, "poses").value_or("");
    const std::size_t files = all.count("part") + all.count("environment") + all.count("poses");
    if (files != 0 && files != 3) {
        throw std::invalid_argument(
            "only some of --part, --environment and --poses are given, expected all three or none");
    }
    if (files != 0) choices.scenes.clear();
    choices.builds = {atLeast(0, all, "build-rounds"), atLeast(0.0, all, "build-budget")};
    choices.targets = targetsOf(all);
    choices.trees = treeOptions(all);
    choices.oraclePoses = static_cast<std::size_t>(atLeast(0, all, "oracle-poses"));
    return choices;
}

}  // namespace

std::optional<BenchChoices> readOptions(int count, char** words, std::ostream& help) {
    options::variables_map all;
    options::store(options::parse_command_line(count, words, allOptions()), all);
    if (all.count("help") != 0) {
        help << allOptions();
        return std::nullopt;
    }
    return choicesOf(all);
}

}  // namespace clearway::testing
