// clearway scene: makes a demo scene and writes its meshes, its problem and a path that solves it.
#include <filesystem>
#include <stdexcept>

#include "cli/command_line.h"
#include "cli/print.h"
#include "scenes/generated_scene.h"
#include "scenes/tunnel_console.h"

namespace clearway {

namespace {

constexpr std::int64_t kMostTriangles = 4000000;

GeneratedScene makeTunnelConsoleScene(const Options& options) {
    const auto triangles = [&](const char* name, std::size_t byDefault) {
        return options.has(name) ? static_cast<std::size_t>(options.integer(name, 1, kMostTriangles))
                                 : byDefault;
    };
    TunnelConsoleOptions scene;
    if (options.has("seed")) scene.seed = static_cast<std::uint64_t>(options.integer("seed", 0, INT64_MAX));
    scene.partTriangles = triangles("part-triangles", scene.partTriangles);
    scene.environmentTriangles = triangles("environment-triangles", scene.environmentTriangles);
    if (options.has("clearance")) scene.clearance = options.positive("clearance");
    return makeTunnelConsole(scene);
}

struct NamedScene {
    const char* name;
    GeneratedScene (*make)(const Options& options);
};

constexpr NamedScene kScenes[] = {
    {"tunnel-console", makeTunnelConsoleScene},
};

std::string sceneNames() {
    std::string all;
    for (const NamedScene& scene : kScenes) all += (all.empty() ? "" : ", ") + std::string(scene.name);
    return all;
}

const NamedScene& sceneNamed(const std::string& name) {
    for (const NamedScene& scene : kScenes) {
        if (name == scene.name) return scene;
    }
    throw std::invalid_argument("the scene is '" + name + "', expected one of " + sceneNames());
}

/// Said before the scene is made rather than after.
void requireFolderOrNothing(const std::string& folder) {
    std::error_code ignored;
    if (std::filesystem::exists(folder, ignored) && !std::filesystem::is_directory(folder, ignored)) {
        throw std::invalid_argument("--out is '" + folder + "', a file, expected a folder or a new name");
    }
}

CommandLine sceneCommandLine() {
    const TunnelConsoleOptions defaults;
    CommandLine commandLine;
    commandLine.usage = "clearway scene NAME --out DIR [options]";
    commandLine.purpose =
        "Makes a demo scene and writes its two meshes, the problem (.cfg) and a path that solves it (.path) "
        "into DIR.\n"
        "Scenes: " +
        sceneNames() + ". The same options make the same files. Lengths are millimetres.";
    commandLine.positional = {"NAME"};
    commandLine.options.add_options()                                                                       //
        ("out", optionValue("DIR"), "folder for the files, made if need be")                                //
        ("seed", optionValue("N"), ("varies the details (" + std::to_string(defaults.seed) + ")").c_str())  //
        ("part-triangles", optionValue("N"),
         ("triangles of the part, to 5 % (" + std::to_string(defaults.partTriangles) + ")").c_str())  //
        ("environment-triangles", optionValue("N"),
         ("triangles of the environment, to 5 % (" + std::to_string(defaults.environmentTriangles) + ")")
             .c_str())  //
        ("clearance", optionValue("D"),
         ("least distance along the path that is written (" + readable(defaults.clearance) + ")").c_str());
    return commandLine;
}

}  // namespace

int scene(const Arguments& arguments) {
    const std::optional<Options> options = parse(sceneCommandLine(), arguments);
    if (!options) return kDone;
    const NamedScene& named = sceneNamed(options->text("NAME"));
    const std::string folder = options->text("out");
    requireFolderOrNothing(folder);
    const GeneratedScene made = named.make(*options);
    const SceneFiles files = writeScene(made, folder);

    printRow("part", files.part + ", " + counted(made.part.triangles.size(), "triangle"));
    printRow("environment",
             files.environment + ", " + counted(made.environment.triangles.size(), "triangle"));
    printRow("problem", files.problem);
    printRow("path", files.path + ", " + counted(made.path.size(), "state"));
    return kDone;
}

}  // namespace clearway
