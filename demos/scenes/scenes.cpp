#include "demos/scenes/scenes.h"

#include <filesystem>
#include <ostream>
#include <sstream>
#include <stdexcept>

#include "core/replace_file.h"
#include "core/text.h"

namespace clearway::scenes {

namespace {

/// "tunnel-console-3" without its "-3".
std::string withoutVersion(const std::string& name) {
    return name.substr(0, name.rfind('-'));
}

std::string allNames() {
    return joined(namesOf(kScenes));
}

/// How often the part is moved and written until its mean lies at its origin. One move suffices up to
/// rounding to float.
constexpr int kMostMoves = 4;

/// mm; the float sum over many vertices is no more accurate.
constexpr double kCentred = 1e-4;

void move(Mesh& mesh, const Vector3& shift) {
    for (Vector3& vertex : mesh.vertices) vertex = (vertex + shift).cast<float>().cast<double>();
}

/// The state that puts the part, moved by `shift`, where its surface was before.
PartState afterMove(PartState state, const Vector3& shift) {
    state.position -= state.rotation * shift;
    return state;
}

/// Writes the part so that OMPL.app finds its mean at the origin; returns the translation.
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

const NamedScene& sceneNamed(const std::string& name) {
    const NamedScene* newest = nullptr;
    for (const NamedScene& scene : kScenes) {
        if (name == scene.name) return scene;
        if (name == withoutVersion(scene.name)) newest = &scene;
    }
    if (newest != nullptr) return *newest;
    throw std::invalid_argument("the scene is '" + name + "'" + didYouMean(name, namesOf(kScenes)) +
                                ", expected one of " + allNames());
}

void requireClearance(double clearance, double least, double most) {
    if (clearance >= least && clearance <= most) return;
    std::ostringstream message;
    message << "clearance is " << clearance << ", expected " << least << " to " << most << " (millimetres)";
    throw std::invalid_argument(message.str());
}

void centrePart(GeneratedScene& scene) {
    Vector3 mean = Vector3::Zero();
    for (const Vector3& vertex : scene.part.vertices) mean += vertex;
    mean = (mean / static_cast<double>(scene.part.vertices.size())).array().round();
    for (Vector3& vertex : scene.part.vertices) {
        vertex = (vertex - mean).cast<float>().cast<double>() + Vector3::Zero();
    }
    for (PartState& state : scene.path) state.position += state.rotation * mean;
}

void setProblem(GeneratedScene& scene, double room) {
    Box positions;
    for (const PartState& state : scene.path) positions.extend(state.position);
    const Vector3 margin = Vector3::Constant(room);
    Problem& problem = scene.problem;
    problem.start = scene.path.front();
    problem.goal = scene.path.back();
    problem.volume = Box((positions.min() - margin).array().floor().matrix(),
                         (positions.max() + margin).array().ceil().matrix());
}

void statePathAsProblem(GeneratedScene& scene, double room) {
    centrePart(scene);
    setProblem(scene, room);
}

SceneFiles writeScene(const GeneratedScene& scene, const std::string& folder) {
    makeFolder(folder);
    const auto inFolder = [&](const std::string& ending) {
        return (std::filesystem::path(folder) / (scene.name + ending)).string();
    };
    const SceneFiles files{inFolder("_part.obj"), inFolder("_environment.obj"), inFolder(".cfg"),
                           inFolder(".path"),     inFolder("_replay.poses"),    inFolder(".png")};
    // All files are written or none: every obstacle is found before the first file is written.
    const std::string all[] = {files.part, files.environment, files.problem,
                               files.path, files.replay,      files.preview};
    for (const std::string& file : all) requireReplaceable(file);
    // Removing first ensures that files of two scenes never stand side by side, whatever interrupts the
    // writing.
    for (const std::string& file : all) std::filesystem::remove(file);

    const Vector3 moved = writeCentred(scene.part, files.part);
    saveMesh(scene.environment, files.environment);
    Problem problem = scene.problem;
    problem.file = files.problem;
    problem.meshes.robot = files.part;
    problem.meshes.world = files.environment;
    problem.meshes.asOmplApp = true;
    problem.start = afterMove(problem.start, moved);
    problem.goal = afterMove(problem.goal, moved);
    if (problem.volume) {
        // The part's origin moved by at most moved.norm(), whatever the rotation.
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
