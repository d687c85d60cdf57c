#include "demos/scenes/record_scene.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <limits>

#include "clearway/planning/check_path.h"
#include "clearway/query.h"
#include "core/number.h"
#include "program/cli/render.h"
#include "program/options/command_line.h"
#include "program/options/facts.h"
#include "program/options/print.h"

namespace clearway::cli {

namespace {

constexpr double kNear = 1.5;               // near: within this many stated clearances
constexpr std::size_t kNearSamples = 2000;  // samples along the path
constexpr int kReplayPoses = 1000;
constexpr std::uint64_t kReplaySeed = 1;
constexpr int kPreviewWidth = 960, kPreviewHeight = 540;

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
    Model part = Model::build(partMesh), environment = Model::build(environmentMesh);
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
    return fmt::format(
        "clearway-scene {} --seed {} --part-triangles {} --environment-triangles {} --clearance {}",
        origin.row.name, options.seed, options.partTriangles, options.environmentTriangles,
        shortNumber(options.clearance));
}

std::string Recorder::contents() const {
    const auto of = [](const Mesh& mesh) {
        return fmt::format("{} in {}", counted(mesh.triangles.size(), "triangle"),
                           counted(mesh.components.size(), "component"));
    };
    return "Part: " + of(partMesh) + "; environment: " + of(environmentMesh) + ".";
}

/// The share of the path's length along which the environment is near.
double Recorder::nearShare() const {
    const PathLine line(path, part.radiusAboutOrigin());
    std::size_t near = 0;
    for (const double share : evenShares(kNearSamples))
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
    const std::string about =
        fmt::format("{} beside the path, {} of them colliding", counted(poses.size(), "pose"),
                    percent(static_cast<double>(colliding) / static_cast<double>(poses.size())));
    writePoses(poses, files.replay);
    scenes::addComment(files.replay, {about + "; made by", command()});
    return about;
}

void Recorder::writePreview() const {
    const PathLine line(path, part.radiusAboutOrigin());
    std::vector<render::PosedPart> poses = posesAt(line, evenShares(kUsualPoses), clearance, false);
    chooseGhosts(part, poses);
    render::RenderOptions drawing;
    drawing.view = origin.row.preview;
    drawing.width = kPreviewWidth;
    drawing.height = kPreviewHeight;
    drawing.isStopped = isInterrupted;
    const render::Image picture = render::render(
        partMesh, environmentMesh, poses, posesAt(line, evenShares(kWayPoses), clearance, false), drawing);
    if (!picture.pixels.empty()) render::writePng(picture, files.preview);
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
                      << motion.segments[0].motion.whyInvalid.words() << "\n";
            return false;
        }
        least = std::min(least, stated + motion.lowerClearance);
    }
    const std::string keptClearance = shortened(least) + " (certified), expected " + readable(stated);
    const std::string near =
        percent(recorder.nearShare()) + " of the path is within " + readable(kNear * stated);
    if (isInterrupted()) return true;
    const std::string replay = recorder.writeReplay();

    const std::string pathFile = std::filesystem::path(files.path).filename().string();
    scenes::addComment(files.problem, {"Made by", recorder.command(), recorder.contents(),
                                       pathFile + " solves it; least clearance along it: " + keptClearance +
                                           "; " + near + "."});
    scenes::addComment(
        files.path, {"Made by", recorder.command(), "Least clearance: " + keptClearance + "; " + near + "."});
    tell({{"least clearance", keptClearance, "least_clearance", toJson(least)},
          {"near", near},
          {"replay", files.replay + ", " + replay, "replay", files.replay}});
    if (!wantsPreview || isInterrupted()) return true;
    recorder.writePreview();
    if (isInterrupted()) return true;
    tell({{"preview", files.preview, "preview", files.preview}});
    return true;
}

}  // namespace clearway::cli
