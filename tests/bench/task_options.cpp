#include "bench/task_options.h"

#include <sstream>
#include <stdexcept>

#include "core/number.h"

namespace clearway::testing {
namespace {

namespace options = boost::program_options;

template <typename Number>
Number requireAtLeast(Number least, Number value, const char* option) {
    if (value >= least) return value;
    throw std::invalid_argument(std::string(option) + " is " + shortNumber(double(value)) +
                                ", expected at least " + shortNumber(double(least)));
}

std::optional<std::size_t> triangles(const options::variables_map& given, const char* option) {
    if (given.count(option) == 0) return std::nullopt;
    return static_cast<std::size_t>(atLeast(1, given, option));
}

}  // namespace

int atLeast(int least, const options::variables_map& given, const char* option) {
    return requireAtLeast(least, given[option].as<int>(), option);
}

double atLeast(double least, const options::variables_map& given, const char* option) {
    return requireAtLeast(least, given[option].as<double>(), option);
}

std::vector<std::string> splitAtCommas(const std::string& list) {
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

void addTaskOptions(options::options_description& all, const std::string& scenes,
                    const std::string& outFiles) {
    auto add = all.add_options();
    add("help", "print this");
    add("scenes", options::value<std::string>()->default_value(scenes), "the scenes to measure, by letter");
    add("small", "small scenes, which only show that all answers agree");
    add("part-triangles", options::value<int>(),
        "triangles of every part, instead of the scene's own number");
    add("environment-triangles", options::value<int>(),
        "triangles of every environment, instead of the scene's own number");
    add("pose-count", options::value<int>()->default_value(200), "poses of each scene");
    add("seed", options::value<std::uint64_t>()->default_value(1),
        "seed of the poses and of their random orders");
    add("repetitions", options::value<int>()->default_value(5), "repetitions of every pass");
    add("peer-budget", options::value<double>()->default_value(60),
        "seconds for each question to a peer, which repeats less often if it needs more");
    add("lead-in", options::value<double>()->default_value(0.02), "most untimed seconds before a pass");
    add("cpu", options::value<int>()->default_value(-1),
        "keeps passes of one thread on this CPU; -1: any CPU");
    add("without-peers", "measures clearway alone");
    add("out", options::value<std::string>(), ("folder for " + outFiles).c_str());
}

TaskChoices taskChoices(const options::variables_map& given) {
    TaskChoices choices;
    choices.scenes = splitAtCommas(given["scenes"].as<std::string>());
    for (const std::string& name : choices.scenes) benchSceneNamed(name);
    choices.small = given.count("small") != 0;
    choices.partTriangles = triangles(given, "part-triangles");
    choices.environmentTriangles = triangles(given, "environment-triangles");
    choices.poseCount = atLeast(1, given, "pose-count");
    choices.seed = given["seed"].as<std::uint64_t>();
    choices.schedule.repetitions = atLeast(1, given, "repetitions");
    choices.schedule.peerBudget = atLeast(0.0, given, "peer-budget");
    choices.schedule.leadIn = atLeast(0.0, given, "lead-in");
    choices.schedule.cpu = atLeast(-1, given, "cpu");
    choices.withPeers = given.count("without-peers") == 0;
    if (given.count("out") != 0) choices.out = given["out"].as<std::string>();
    return choices;
}

BenchTask makeTask(const TaskChoices& choices, const std::string& scene) {
    const BenchScene& row = benchSceneNamed(scene);
    BenchSize size = choices.small ? row.small : row.full;
    if (choices.partTriangles) size.partTriangles = *choices.partTriangles;
    if (choices.environmentTriangles) size.environmentTriangles = *choices.environmentTriangles;
    return makeTask(row, size, choices.poseCount, choices.seed);
}

}  // namespace clearway::testing
