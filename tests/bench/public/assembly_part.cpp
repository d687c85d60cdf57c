#include "bench/public/assembly_part.h"

#include <ompl/base/SpaceInformation.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <stdexcept>

#include "clearway/overlap.h"
#include "clearway/planning/motion_validator.h"
#include "clearway/planning/plan.h"
#include "clearway/planning/validity_checker.h"
#include "core/clock.h"
#include "core/number.h"
#include "planning/space/ompl_states.h"

namespace clearway::testing::public_problems {
namespace {

constexpr double kLeastOverlapPerDiagonal = 0.002;
constexpr double kMoreThanDepth = 1.35;  ///< faces move inwards by three quarters of the overlap
constexpr double kNextOverlap = 1.1;     ///< where the shrunk part still touches: the next one tried
constexpr int kMostOverlaps = 12;
constexpr int kDirections = 1000;

Problem problemOf(const Assembly& assembly, std::size_t part) {
    Problem problem;
    problem.name = std::filesystem::path(assembly.files[part]).stem().string();
    problem.meshes.robot = assembly.files[part];
    for (std::size_t i = 0; i < assembly.files.size(); ++i) {
        if (i == part) continue;
        if (problem.meshes.world.empty())
            problem.meshes.world = assembly.files[i];
        else
            problem.meshes.furtherWorlds.push_back(assembly.files[i]);
    }
    problem.outside = Outside{};
    problem.meshes.asOmplApp = false;
    return problem;
}

/// Space information with room around the scene, and clearway's checker.
ob::SpaceInformationPtr roomySpace(const Scene& scene, double room) {
    const Box all = scene.environmentBox().merged(scene.part.box());
    const Box bounds(all.min() - Vector3::Constant(2 * room), all.max() + Vector3::Constant(2 * room));
    const auto si = std::make_shared<ob::SpaceInformation>(
        planning::makeSpace(Space::kSe3, bounds, scene.part.radiusAboutOrigin()));
    si->setStateValidityChecker(std::make_shared<planning::ValidityChecker>(si, scene));
    si->setup();
    return si;
}

double roomOf(const Scene& scene) {
    return scene.environmentBox().diagonal().norm() + scene.part.box().diagonal().norm();
}

bool isStartFree(const Problem& problem, const Scene& scene) {
    const ob::SpaceInformationPtr si = roomySpace(scene, roomOf(scene));
    return si->isValid(planning::toOmpl(si->getStateSpace(), problem.space, problem.start).get());
}

/// How many directions, evenly spread over the sphere, lead straight outside.
int straightPaths(const Problem& problem, const Scene& scene) {
    const double length = roomOf(scene);
    const ob::SpaceInformationPtr si = roomySpace(scene, length);
    const planning::MotionValidator validator(si, scene);
    const auto from = planning::toOmpl(si->getStateSpace(), problem.space, problem.start);
    int ways = 0;
    for (int i = 0; i < kDirections; ++i) {
        const double z = 1 - (2 * i + 1.0) / kDirections, angle = i * M_PI * (3 - std::sqrt(5.0));
        const double around = std::sqrt(1 - z * z);
        PartState outside = problem.start;
        outside.position += length * Vector3(around * std::cos(angle), around * std::sin(angle), z);
        ways += validator.checkMotion(from.get(),
                                      planning::toOmpl(si->getStateSpace(), problem.space, outside).get());
    }
    return ways;
}

struct Prepared {
    std::optional<Scene> scene;
    std::size_t triangles = 0, touching = 0;
    double depth = 0, overlap = 0;
};

/// Sets the problem's overlaps so that its start is free, and loads its scene.
Prepared prepare(Problem& problem) {
    const Mesh partMesh = loadPart(problem);
    const Model part = Model::build(partMesh);
    Workspace workspace;
    Prepared prepared;
    prepared.triangles = partMesh.triangles.size();
    std::vector<std::string> names;
    std::optional<OverlapMeter> meter;
    for (const std::string& file : worldFiles(problem)) {
        const Mesh mesh = loadMesh(file);
        if (!collides(part, Model::build(mesh), poseOf(problem.start), workspace)) continue;
        names.push_back(std::filesystem::path(file).filename().string());
        if (!meter) meter.emplace(partMesh);
        prepared.depth = std::max(prepared.depth, meter->deepest(mesh, poseOf(problem.start)).upper);
    }
    prepared.touching = names.size();
    if (names.empty()) {
        prepared.scene = loadScene(problem).scene;
        return prepared;
    }
    prepared.overlap =
        std::max(kMoreThanDepth * prepared.depth, kLeastOverlapPerDiagonal * part.box().diagonal().norm());
    for (int i = 0; i < kMostOverlaps; ++i, prepared.overlap *= kNextOverlap) {
        for (const std::string& name : names) problem.rules.overlap.byName[name] = prepared.overlap;
        prepared.scene = loadScene(problem).scene;
        if (isStartFree(problem, *prepared.scene)) return prepared;
    }
    throw std::invalid_argument("no overlap up to " + shortNumber(prepared.overlap) + " frees the start");
}

}  // namespace

std::string runPart(const Assembly& assembly, std::size_t part, double seconds, const std::string& config,
                    const std::string& path) {
    Problem problem = problemOf(assembly, part);
    Prepared prepared;
    planning::PlanReport report;
    bool isFound = false;
    double preparing = 0;
    std::string straight, note;
    try {
        const Clock::time_point begin = Clock::now();
        prepared = prepare(problem);
        preparing = secondsSince(begin);
        writeProblem(problem, config);
        planning::PlanOptions options;
        options.seconds = seconds;
        report = plan(problem, *prepared.scene, options);
        isFound = report.outcome == planning::PlanReport::Outcome::kFound;
        if (isFound)
            writePath(report.path, problem.space, path);
        else
            straight = std::to_string(straightPaths(problem, *prepared.scene));
    } catch (const std::exception& error) {
        note = error.what();
    }
    std::replace(note.begin(), note.end(), ',', ';');
    std::replace(report.foundBy.begin(), report.foundBy.end(), ',', ';');
    std::string row = std::to_string(prepared.triangles) + "," + std::to_string(prepared.touching);
    for (const double value : {prepared.depth, prepared.overlap, preparing}) {
        row += "," + shortNumber(value);
    }
    return row + "," + (isFound ? "1," : "0,") + shortNumber(report.planningSeconds) + "," + report.foundBy +
           "," + (isFound ? shortNumber(report.audit.lowerClearance) : std::string()) + "," + straight + "," +
           note;
}

}  // namespace clearway::testing::public_problems
