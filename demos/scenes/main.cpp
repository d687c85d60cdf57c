// The program clearway-scene: makes a demo scene.
#include <filesystem>

#include "clearway/targets.h"
#include "demos/scenes/record_scene.h"
#include "program/options/facts.h"
#include "program/options/print.h"
#include "program/options/program.h"

namespace clearway::cli {

namespace {

constexpr std::int64_t kMostTriangles = 4000000;

/// The scenes, one a line: name, description and defaults.
std::string sceneList() {
    std::string all;
    for (const scenes::NamedScene& scene : scenes::kScenes) {
        const scenes::SceneOptions& defaults = scene.defaults;
        all += "  " + std::string(scene.name) + ": " + scene.about + " (seed " +
               std::to_string(defaults.seed) + ", " + std::to_string(defaults.partTriangles) + " / " +
               std::to_string(defaults.environmentTriangles) + " triangles, clearance " +
               readable(defaults.clearance) + ")\n";
    }
    return all;
}

struct SceneArguments {
    const scenes::NamedScene* named = nullptr;
    scenes::SceneOptions options;
    std::string folder;
    bool hasNoPreview = false;
};

bool readArguments(const Arguments& arguments, SceneArguments& given) {
    CommandLine line("clearway-scene NAME --out DIR [options]",
                     "Makes a demo scene and writes into DIR its two meshes, the problem (.cfg), an audited "
                     "path that solves it\n"
                     "(.path), poses beside the path to measure queries at (_replay.poses), a stated share "
                     "of them colliding,\n"
                     "and a picture (.png). Scenes and their defaults:\n" +
                         sceneList() +
                         "A name without its version means the newest. The same options make the same files. "
                         "Lengths are in "
                         "millimetres.");
    // Arguments are read before options, so that options can change the scene's defaults.
    line.argument("NAME", [&](const std::string& name) {
        given.named = &scenes::sceneNamed(name);
        given.options = given.named->defaults;
    });
    line.option("--out DIR", "folder for the files, made if need be", folder(given.folder),
                CommandLine::Count::kRequired);
    line.option("--seed N", "varies the details", integer<std::uint64_t>(given.options.seed, 0, INT64_MAX));
    line.option("--part-triangles N", "triangles of the part, to 5 %",
                integer<std::size_t>(given.options.partTriangles, 1, kMostTriangles));
    line.option("--environment-triangles N", "triangles of the environment, to 5 %",
                integer<std::size_t>(given.options.environmentTriangles, 1, kMostTriangles));
    line.option("--clearance D", "least distance along the path that is written",
                positive(given.options.clearance));
    line.flag("--no-preview", "writes no picture", given.hasNoPreview);
    addJson(line);
    return line.parse(arguments);
}

/// Removes the files, and the folder if it is new. Part of a scene is of no use.
void removeScene(const scenes::SceneFiles& files, const std::string& folder, bool isFolderNew) {
    std::error_code ignored;
    for (const std::string& file :
         {files.part, files.environment, files.problem, files.path, files.replay, files.preview}) {
        std::filesystem::remove(file, ignored);
    }
    if (isFolderNew) std::filesystem::remove(folder, ignored);  // keeps a folder that holds anything else
}

int tellInterruptedScene() {
    printRow("scene", "none, interrupted");
    return kAnswerIsNo;
}

int makeScene(const Arguments& arguments) {
    currentTarget();  // refuses CLEARWAY_TARGET before any work
    SceneArguments given;
    if (!readArguments(arguments, given)) return kDone;
    const SceneOrigin origin{*given.named, given.options};
    OutputFiles outputs({});
    requireFactsFile(outputs);
    heedInterrupts();
    const ElapsedLine elapsed("making the scene");
    const scenes::GeneratedScene made = given.named->make(given.options);
    if (isInterrupted()) return tellInterruptedScene();
    std::error_code ignored;
    const bool isFolderNew = !std::filesystem::exists(given.folder, ignored);
    const scenes::SceneFiles files = writeScene(made, given.folder);

    const auto fileFact = [](const char* name, const std::string& file, std::size_t count,
                             const std::string& counts) -> Fact {
        return {name, file + ", " + counted(count, counts), name, {{"file", file}, {counts + "s", count}}};
    };
    tell({kept("unit", "mm"),
          fileFact("part", files.part, made.part.triangles.size(), "triangle"),
          fileFact("environment", files.environment, made.environment.triangles.size(), "triangle"),
          {"problem", files.problem, "problem", files.problem},
          fileFact("path", files.path, made.path.size(), "state")});
    const bool isKept = recordScene(origin, files, made.environment, !given.hasNoPreview);
    if (isInterrupted()) {
        removeScene(files, given.folder, isFolderNew);
        return tellInterruptedScene();
    }
    requirePrinted();
    return isKept ? kDone : kAnswerIsNo;
}

}  // namespace
}  // namespace clearway::cli

int main(int argc, char** argv) {
    return clearway::cli::runProgram(argc, argv, "clearway-scene", clearway::cli::makeScene);
}
