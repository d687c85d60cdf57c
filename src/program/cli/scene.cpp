#include "program/cli/scene.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <limits>
#include <nlohmann/json.hpp>

#include "clearway/planning/check_path.h"
#include "clearway/query.h"
#include "core/number.h"
#include "program/cli/command_line.h"
#include "program/cli/facts.h"
#include "program/cli/print.h"
#include "program/cli/render.h"

namespace clearway::cli {

namespace {

constexpr std::int64_t kMostTriangles = 4000000;

constexpr double kNear = 1.5;               // near: within this many stated clearances
constexpr std::size_t kNearSamples = 2000;  // samples along the path
constexpr int kReplayPoses = 1000;
constexpr std::uint64_t kReplaySeed = 1;
constexpr int kPreviewWidth = 960, kPreviewHeight = 540;

/// Rounds down to so many decimals.
std::string roundedDown(double value, int decimals) {
    const double unit = std::pow(10.0, decimals);
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", decimals, std::floor(value * unit) / unit);
    return text;
}

std::string percent(double share) {
    return readable(std::round(1000 * share) / 10) + " %";
}

struct Recorder {
    const SceneOrigin& origin;
    const scenes::SceneFiles& files;
    const Mesh& environmentMesh;
    Problem problem = readProblem(files.problem);
    std::vector<PartState> path = readPath(files.path, problem.space);
    Mesh partMesh = loadPart(problem);
    // The environment's whole tree, because replayed poses may leave the problem's bounds.
    Model part = Model::build(partMesh, buildPreset("fast")),
          environment = Model::build(environmentMesh, buildPreset("fast"));
    SceneClearance clearance{Scene(part, environment)};

    double stated() const { return origin.options.clearance; }
    std::string command() const;
    std::string contents() const;
    double nearShare() const;
    std::vector<planning::PathAudit> auditMotions() const;
    std::string writeReplay() const;
    void writePreview() const;
};

/// The command that makes equal files again.
std::string Recorder::command() const {
    const scenes::SceneOptions& options = origin.options;
    return "clearway scene " + std::string(origin.row.name) + " --seed " + std::to_string(options.seed) +
           " --part-triangles " + std::to_string(options.partTriangles) + " --environment-triangles " +
           std::to_string(options.environmentTriangles) + " --clearance " + shortNumber(options.clearance);
}

std::string Recorder::contents() const {
    const auto of = [](const Mesh& mesh) {
        return counted(mesh.triangles.size(), "triangle") + " in " +
               counted(mesh.components.size(), "component");
    };
    return "Part: " + of(partMesh) + "; environment: " + of(environmentMesh) + ".";
}

/// The share of the path's length along which the environment is near.
double Recorder::nearShare() const {
    const report::PathLine line(path, part.radiusAboutOrigin());
    std::size_t near = 0;
    for (const double share : report::evenShares(kNearSamples))
        near += clearance.at(poseOf(line.at(share))).lower <= kNear * stated();
    return static_cast<double>(near) / kNearSamples;
}

/// Audits the motions in parallel: this is most of the run time. An audit certifies only a share of the
/// clearance above the margin; with the whole stated clearance as the margin it certifies nearly all.
std::vector<planning::PathAudit> Recorder::auditMotions() const {
    const Scene scene(part, environment, stated());
    std::vector<planning::PathAudit> audits(path.size() - 1);
    tbb::parallel_for(std::size_t(0), audits.size(), [&](std::size_t i) {
        if (!isInterrupted())
            audits[i] =
                planning::checkPath(problem, scene, {path[i], path[i + 1]}, {/*profile*/ false}).audit;
    });
    return audits;
}

/// Returns the text of the row about the replay poses.
std::string Recorder::writeReplay() const {
    const scenes::Replay& replay = origin.row.replay;
    const scenes::PoseTask task{part, environment, scenes::beginningOf(path, replay.pathEnd)};
    const std::vector<Pose> poses =
        scenes::posesColliding(task, replay.collidingShare, kReplayPoses, kReplaySeed, replay.turns);
    Workspace workspace;
    std::size_t colliding = 0;
    for (const Pose& pose : poses) colliding += collides(task.part, task.environment, pose, workspace);
    const std::string about = counted(poses.size(), "pose") + " beside the path, " +
                              percent(static_cast<double>(colliding) / static_cast<double>(poses.size())) +
                              " of them colliding";
    writePoses(poses, files.replay);
    scenes::addComment(files.replay, {about + "; made by", command()});
    return about;
}

void Recorder::writePreview() const {
    const report::PathLine line(path, part.radiusAboutOrigin());
    std::vector<render::PosedPart> poses = posesAt(line, report::evenShares(kUsualPoses), clearance, false);
    chooseGhosts(part, poses);
    render::RenderOptions drawing;
    drawing.view = origin.row.preview;
    drawing.width = kPreviewWidth;
    drawing.height = kPreviewHeight;
    drawing.isStopped = isInterrupted;
    const render::Image picture =
        render::render(partMesh, environmentMesh, poses,
                       posesAt(line, report::evenShares(kWayPoses), clearance, false), drawing);
    if (!picture.pixels.empty()) render::writePng(picture, files.preview);
}

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
    CommandLine line("clearway scene NAME --out DIR [options]",
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

}  // namespace

bool recordScene(const SceneOrigin& origin, const scenes::SceneFiles& files, const Mesh& environment,
                 bool wantsPreview) {
    const Recorder recorder{origin, files, environment};
    const double stated = recorder.stated();
    double least = std::numeric_limits<double>::infinity();
    const std::vector<planning::PathAudit> audits = recorder.auditMotions();
    if (isInterrupted()) return true;
    for (const planning::PathAudit& motion : audits) {
        if (!motion.isValid()) {
            std::cerr << "clearway: the path does not keep the clearance " << readable(stated) << ": "
                      << motion.segments[0].trouble << "\n";
            return false;
        }
        least = std::min(least, stated + motion.lowerClearance);
    }
    const std::string kept = roundedDown(least, 3) + " (certified), expected " + readable(stated);
    const std::string near =
        percent(recorder.nearShare()) + " of the path is within " + readable(kNear * stated);
    if (isInterrupted()) return true;
    const std::string replay = recorder.writeReplay();

    const std::string pathFile = std::filesystem::path(files.path).filename().string();
    scenes::addComment(files.problem,
                       {"Made by", recorder.command(), recorder.contents(),
                        pathFile + " solves it; least clearance along it: " + kept + "; " + near + "."});
    scenes::addComment(files.path,
                       {"Made by", recorder.command(), "Least clearance: " + kept + "; " + near + "."});
    facts()["least_clearance"] = toJson(least);
    facts()["replay"] = files.replay;
    printRow("least clearance", kept);
    printRow("near", near);
    printRow("replay", files.replay + ", " + replay);
    if (!wantsPreview || isInterrupted()) return true;
    recorder.writePreview();
    if (isInterrupted()) return true;
    printRow("preview", files.preview);
    facts()["preview"] = files.preview;
    return true;
}

int scene(const Arguments& arguments) {
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

    printRow("part", files.part + ", " + counted(made.part.triangles.size(), "triangle"));
    printRow("environment",
             files.environment + ", " + counted(made.environment.triangles.size(), "triangle"));
    facts()["unit"] = "mm";
    facts()["part"] = {{"file", files.part}, {"triangles", made.part.triangles.size()}};
    facts()["environment"] = {{"file", files.environment}, {"triangles", made.environment.triangles.size()}};
    facts()["problem"] = files.problem;
    facts()["path"] = {{"file", files.path}, {"states", made.path.size()}};
    printRow("problem", files.problem);
    printRow("path", files.path + ", " + counted(made.path.size(), "state"));
    const bool isKept = recordScene(origin, files, made.environment, !given.hasNoPreview);
    if (isInterrupted()) {
        removeScene(files, given.folder, isFolderNew);
        return tellInterruptedScene();
    }
    requirePrinted();
    return isKept ? kDone : kAnswerIsNo;
}

}  // namespace clearway::cli
