#include "bench/bench_options.h"

#include <algorithm>
#include <boost/program_options.hpp>
#include <iostream>
#include <sstream>
#include <stdexcept>

#include "clearway/targets.h"

namespace clearway::testing {
namespace {

namespace options = boost::program_options;

std::vector<std::string> split(const std::string& list) {
    std::vector<std::string> words;
    std::istringstream in(list);
    for (std::string word; std::getline(in, word, ',');) words.push_back(word);
    return words;
}

std::string allSceneNames() {
    std::string all;
    for (const BenchScene& scene : benchScenes()) all += (all.empty() ? "" : ",") + std::string(scene.name);
    return all;
}

options::options_description allOptions() {
    options::options_description all("options");
    auto add = all.add_options();
    const auto text = [](const std::string& value) {
        return options::value<std::string>()->default_value(value);
    };
    add("help", "print this");
    add("scenes", text(allSceneNames()), "which, by letter");
    add("small", "the scenes at sizes that only show that all agree");
    add("part-triangles", options::value<std::size_t>(), "of every scene, instead of its own number");
    add("environment-triangles", options::value<std::size_t>(), "likewise");
    add("part", options::value<std::string>(),
        "mesh file, instead of scenes; then also --environment and --poses");
    add("environment", options::value<std::string>(), "mesh file");
    add("poses", options::value<std::string>(), "poses file");
    add("pose-count", options::value<int>()->default_value(200), "of each scene");
    add("seed", options::value<std::uint64_t>()->default_value(1), "of the poses and of the shuffled order");
    add("repetitions", options::value<int>()->default_value(5), "of every pass");
    add("peer-budget", options::value<double>()->default_value(60),
        "seconds for each question to a peer; it repeats less often if need be");
    add("lead-in", options::value<double>()->default_value(0.02), "seconds at most, untimed, before a pass");
    add("build-rounds", options::value<int>()->default_value(5), "of builds; 0: none");
    add("build-budget", options::value<double>()->default_value(60), "seconds for a scene's builds");
    add("without-peers", "times clearway alone");
    add("targets", text("avx2"), "instruction sets timed besides the best one, or 'all'");
    add("preset", text("best"), "options of the trees, to start from");
    add("general-split", options::value<std::string>(), "strategy, instead of the preset's");
    add("leaf-split", options::value<std::string>(), "likewise");
    add("leaf-size", options::value<int>(), "likewise");
    add("node-width", options::value<int>(), "likewise");
    add("fit", options::value<std::string>(), "likewise");
    add("cpu", options::value<int>()->default_value(-1), "keeps passes of one thread on this CPU");
    add("oracle-poses", options::value<std::size_t>()->default_value(3),
        "poses the oracle is asked about although all agree");
    add("out", options::value<std::string>(), "folder for summary.csv, builds.csv and poses_SCENE.csv");
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

/// The instruction sets asked for that this machine and build have.
std::vector<std::string> targetsOf(const options::variables_map& given) {
    std::vector<std::string> chosen;
    const std::string targets = given["targets"].as<std::string>();
    const std::vector<std::string> available = availableTargets();
    for (const std::string& target : targets == "all" ? available : split(targets)) {
        const bool isThere = std::find(available.begin(), available.end(), target) != available.end();
        if (!isThere) std::cout << "this machine or build has no " << target << ": its row is left out\n";
        if (isThere) chosen.push_back(target);
    }
    return chosen;
}

Schedule scheduleOf(const options::variables_map& given) {
    Schedule schedule;
    schedule.repetitions = std::max(1, given["repetitions"].as<int>());
    schedule.peerBudget = given["peer-budget"].as<double>();
    schedule.leadIn = given["lead-in"].as<double>();
    schedule.cpu = given["cpu"].as<int>();
    return schedule;
}

template <typename Value>
std::optional<Value> given(const options::variables_map& all, const char* name) {
    if (all.count(name) == 0) return std::nullopt;
    return all[name].as<Value>();
}

BenchChoices choicesOf(const options::variables_map& all) {
    BenchChoices choices;
    choices.part = given<std::string>(all, "part").value_or("");
    choices.environment = given<std::string>(all, "environment").value_or("");
    choices.poses = given<std::string>(all, "poses").value_or("");
    const std::size_t files = all.count("part") + all.count("environment") + all.count("poses");
    if (files != 0 && files != 3) {
        throw std::invalid_argument("--part, --environment and --poses are given together or not at all");
    }
    if (files == 0) choices.scenes = split(all["scenes"].as<std::string>());
    for (const std::string& name : choices.scenes) benchSceneNamed(name);
    choices.small = all.count("small") != 0;
    choices.partTriangles = given<std::size_t>(all, "part-triangles");
    choices.environmentTriangles = given<std::size_t>(all, "environment-triangles");
    choices.poseCount = all["pose-count"].as<int>();
    if (choices.poseCount < 1) {
        throw std::invalid_argument("pose-count is " + std::to_string(choices.poseCount) +
                                    ", expected at least 1");
    }
    choices.seed = all["seed"].as<std::uint64_t>();
    choices.schedule = scheduleOf(all);
    choices.builds = {all["build-rounds"].as<int>(), all["build-budget"].as<double>()};
    choices.withPeers = all.count("without-peers") == 0;
    choices.targets = targetsOf(all);
    choices.trees = treeOptions(all);
    choices.oraclePoses = all["oracle-poses"].as<std::size_t>();
    choices.out = given<std::string>(all, "out").value_or("");
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
