#include "program/scenes/generated_scene.h"

#include <filesystem>
#include <ostream>
#include <stdexcept>

#include "core/lines.h"
#include "core/replace_file.h"

namespace clearway::scenes {

namespace {

/// How often the part is written until its mean lies at its origin. One move does it but for rounding to
/// float.
constexpr int kMostMoves = 4;

/// mm; the float sum of many vertices is no better.
constexpr double kCentred = 1e-4;

void move(Mesh& mesh, const Vector3& shift) {
    for (Vector3& vertex : mesh.vertices) vertex = (vertex + shift).cast<float>().cast<double>();
}

/// The state of the part moved by `shift` that leaves its surface where it was.
PartState afterMove(PartState state, const Vector3& shift) {
    state.position -= state.rotation * shift;
    return state;
}

/// Writes the part so that OMPL.app finds its mean at the origin; returns by how much it was moved.
Vector3 writeCentred(Mesh part, const std::string& file) {
    LoadOptions asRobot;
    asRobot.reading = MeshReading::kOmplAppRobot;
    Vector3 moved = Vector3::Zero();
    saveMesh(part, file);
    for (int i = 0; i < kMostMoves; ++i) {
        const Vector3 shift = loadMesh(file, asRobot).origin.shift;
        if (shift.norm() <= kCentred) break;
        move(part, shift);
        moved += shift;
        saveMesh(part, file);
    }
    return moved;
}

}  // namespace

SceneFiles writeScene(const GeneratedScene& scene, const std::string& folder) {
    makeFolder(folder);
    const auto inFolder = [&](const std::string& ending) {
        return (std::filesystem::path(folder) / (scene.name + ending)).string();
    };
    const SceneFiles files{inFolder("_part.obj"), inFolder("_environment.obj"), inFolder(".cfg"),
                           inFolder(".path"),     inFolder("_replay.poses"),    inFolder(".png")};
    // All or none: what stands in the way of the last is found before the first is written.
    const std::string all[] = {files.part, files.environment, files.problem,
                               files.path, files.replay,      files.preview};
    for (const std::string& file : all) requireReplaceable(file);
    // Whatever ends this early: files of two scenes never stand side by side.
    for (const std::string& file : all) std::filesystem::remove(file);

    const Vector3 moved = writeCentred(scene.part, files.part);
    saveMesh(scene.environment, files.environment);
    Problem problem = scene.problem;
    problem.file = files.problem;
    problem.robot = files.part;
    problem.world = files.environment;
    problem.asOmplApp = true;
    problem.start = afterMove(problem.start, moved);
    problem.goal = afterMove(problem.goal, moved);
    if (problem.volume) {
        // The origin went elsewhere, at most as far as the part was moved, whatever the rotation.
        const Vector3 room = Vector3::Constant(std::ceil(moved.norm()));
        problem.volume = Box(problem.volume->min() - room, problem.volume->max() + room);
    }
    writeProblem(problem, files.problem);
    std::vector<PartState> path;
    for (const PartState& state : scene.path) path.push_back(afterMove(state, moved));
    writePath(path, problem.space, files.path);
    return files;
}

void addComment(const std::string& file, const std::vector<std::string>& lines) {
    const std::vector<std::string> before = readLines(file, "a file to comment on");
    replaceFile(file, [&](std::ostream& stream) {
        for (const std::string& line : lines) stream << "# " << line << "\n";
        for (const std::string& line : before) stream << line << "\n";
    });
}

}  // namespace clearway::scenes
