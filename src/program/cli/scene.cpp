// clearway scene: makes a demo scene and writes its meshes, its problem, a path that solves it, poses to
// replay and a picture.
#include <filesystem>
#include <stdexcept>

#include "program/cli/command_line.h"
#include "program/cli/elapsed_line.h"
#include "program/cli/print.h"
#include "program/cli/scene_record.h"
#include "program/scenes/scenes.h"

namespace clearway::cli {

namespace {

constexpr std::int64_t kMostTriangles = 4000000;

scenes::SceneOptions sceneOptions(const Options& options, scenes::SceneOptions scene) {
    const auto triangles = [&](const char* name, std::size_t& count) {
        if (options.has(name)) count = static_cast<std::size_t>(options.integer(name, 1, kMostTriangles));
    };
    if (options.has("seed")) scene.seed = static_cast<std::uint64_t>(options.integer("seed", 0, INT64_MAX));
    triangles("part-triangles", scene.partTriangles);
    triangles("environment-triangles", scene.environmentTriangles);
    if (options.has("clearance")) scene.clearance = options.positive("clearance");
    return scene;
}

/// One line a scene: its name, what it is, what it has unless told otherwise.
std::string sceneList() {
    std::string all;
    for (const scenes::NamedScene& scene : scenes::namedScenes()) {
        const scenes::SceneOptions& defaults = scene.defaults;
        all += "  " + std::string(scene.name) + ": " + scene.about + " (seed " +
               std::to_string(defaults.seed) + ", " + std::to_string(defaults.partTriangles) + " / " +
               std::to_string(defaults.environmentTriangles) + " triangles, clearance " +
               readable(defaults.clearance) + ")\n";
    }
    return all;
}

/// Said before the scene is made rather than after.
void requireFolderOrNothing(const std::string& folder) {
    std::error_code ignored;
    if (std::filesystem::exists(folder, ignored) && !std::filesystem::is_directory(folder, ignored)) {
        throw std::invalid_argument("--out is '" + folder + "', a file, expected a folder or a new name");
    }
}

CommandLine sceneCommandLine() {
    CommandLine commandLine;
    commandLine.usage = "clearway scene NAME --out DIR [options]";
    commandLine.purpose =
        "Makes a demo scene and writes into DIR its two meshes, the problem (.cfg), a path that solves it "
        "(.path), audited,\nposes beside the path to measure queries at (_replay.poses), so many of them "
        "colliding, and a picture (.png).\nScenes, and what they are made with unless options say "
        "otherwise:\n" +
        sceneList() +
        "A name without its version means the newest. The same options make the same files. Lengths are "
        "millimetres.";
    commandLine.positional = {"NAME"};
    commandLine.options.add_options()                                                        //
        ("out", optionValue("DIR"), "folder for the files, made if need be")                 //
        ("seed", optionValue("N"), "varies the details")                                     //
        ("part-triangles", optionValue("N"), "triangles of the part, to 5 %")                //
        ("environment-triangles", optionValue("N"), "triangles of the environment, to 5 %")  //
        ("clearance", optionValue("D"), "least distance along the path that is written")     //
        ("no-preview", "leaves the picture out");
    return commandLine;
}

}  // namespace

int scene(const Arguments& arguments) {
    const std::optional<Options> options = parse(sceneCommandLine(), arguments);
    if (!options) return kDone;
    const scenes::NamedScene& named = scenes::sceneNamed(options->text("NAME"));
    const std::string folder = options->text("out");
    requireFolderOrNothing(folder);
    const SceneOrigin origin{named, sceneOptions(*options, named.defaults)};
    const ElapsedLine elapsed("making the scene");
    const scenes::GeneratedScene made = named.make(origin.options);
    const scenes::SceneFiles files = writeScene(made, folder);

    printRow("part", files.part + ", " + counted(made.part.triangles.size(), "triangle"));
    printRow("environment",
             files.environment + ", " + counted(made.environment.triangles.size(), "triangle"));
    printRow("problem", files.problem);
    printRow("path", files.path + ", " + counted(made.path.size(), "state"));
    const bool isKept = recordScene(origin, files, made.environment, !options->has("no-preview"));
    requirePrinted();
    return isKept ? kDone : kAnswerIsNo;
}

}  // namespace clearway::cli
