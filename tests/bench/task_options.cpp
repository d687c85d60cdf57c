#include "bench/task_options.h"

#include <filesystem>
#include <sstream>
#include <stdexcept>

#include "clearway/problem.h"
#include "core/replace_file.h"
#include "core/text.h"

namespace clearway::testing {

using cli::integer, cli::nonNegative, cli::to;

std::vector<std::string> splitAtCommas(const std::string& list) {
    std::vector<std::string> words;
    std::istringstream in(list);
    for (std::string word; std::getline(in, word, ',');) words.push_back(word);
    return words;
}

std::vector<std::string> allSceneNames() {
    std::vector<std::string> all;
    for (const BenchScene& scene : benchScenes()) all.push_back(scene.name);
    return all;
}

void addTaskOptions(cli::CommandLine& line, const std::string& outFiles, TaskChoices& choices) {
    constexpr std::int64_t kMost = INT32_MAX;
    line.option("--scenes LETTERS",
                "scenes, with commas between them (" + clearway::joined(choices.scenes) + ")",
                [&](const std::string& letters) {
                    choices.scenes = splitAtCommas(letters);
                    for (const std::string& name : choices.scenes) benchSceneNamed(name);
                });
    line.flag("--small", "small scenes, which only show that all answers agree", choices.small);
    line.option("--part-triangles N", "triangles of every scene's part, instead of its own number",
                integer<std::size_t>(choices.partTriangles, 1, kMost));
    line.option("--environment-triangles N",
                "triangles of every scene's environment, instead of its own number",
                integer<std::size_t>(choices.environmentTriangles, 1, kMost));
    line.option("--pose-count N", "poses of each scene (200)", integer<int>(choices.poseCount, 1, kMost));
    line.option("--seed N", "seed of the poses and of their random orders (1)",
                integer<std::uint64_t>(choices.seed, 0, INT64_MAX));
    line.option("--repetitions N", "repetitions of every pass (5)",
                integer<int>(choices.schedule.repetitions, 1, kMost));
    line.option("--peer-budget S", "seconds for each question to a peer, which then repeats less often (60)",
                nonNegative(choices.schedule.peerBudget));
    line.option("--lead-in S", "most seconds of untimed queries before a pass (0.02)",
                nonNegative(choices.schedule.leadIn));
    line.option("--cpu N", "keeps passes of one thread on this CPU; -1: on any (-1)",
                integer<int>(choices.schedule.cpu, -1, kMost));
    line.flag("--without-peers", "measures clearway alone", choices.withoutPeers);
    line.option("--out DIR", "folder for " + outFiles, to(choices.out));
}

void addFileOptions(cli::CommandLine& line, TaskChoices& choices) {
    line.option("--part MESH", "mesh file, instead of scenes; then also --environment and --poses",
                to(choices.part));
    line.option("--environment MESH", "mesh file", to(choices.environment));
    line.option("--poses FILE", "poses file", to(choices.poses));
}

void requireFiles(TaskChoices& choices) {
    const auto files = !choices.part.empty() + !choices.environment.empty() + !choices.poses.empty();
    if (files != 0 && files != 3) {
        throw std::invalid_argument("--part, --environment and --poses are given together or not at all");
    }
    if (files != 0) choices.scenes.clear();
}

BenchTask taskFromFiles(const TaskChoices& choices) {
    BenchTask task;
    task.name = "files";
    task.sceneName = "files";
    task.about = choices.part + " in " + choices.environment;
    task.part = loadMesh(choices.part);
    task.environment = loadMesh(choices.environment);
    task.poses = readPoses(choices.poses).poses;
    return task;
}

BenchTask makeTask(const TaskChoices& choices, const std::string& scene) {
    const BenchScene& row = benchSceneNamed(scene);
    BenchSize size = choices.small ? row.small : row.full;
    if (choices.partTriangles) size.partTriangles = *choices.partTriangles;
    if (choices.environmentTriangles) size.environmentTriangles = *choices.environmentTriangles;
    return makeTask(row, size, choices.poseCount, choices.seed);
}

void writeTable(const std::string& folder, const std::string& file, const std::string& table) {
    if (folder.empty()) return;
    std::filesystem::create_directories(folder);
    replaceFile((std::filesystem::path(folder) / file).string(), [&](std::ostream& out) { out << table; });
}

}  // namespace clearway::testing
