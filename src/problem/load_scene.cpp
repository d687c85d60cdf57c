// From a problem to the scene that planning asks about.
#include <fmt/format.h>

#include <stdexcept>

#include "clearway/errors.h"
#include "clearway/obstacle_groups.h"
#include "clearway/problem.h"
#include "core/number.h"
#include "mesh/components.h"
#include "model/solids.h"
#include "problem/outside.h"
#include "problem/start_remedies.h"

namespace clearway {
namespace {

constexpr double kMostSmaller = 1000;  ///< a part that is smaller than its surroundings by this factor, and
constexpr double kMostLarger = 10;     ///< one that is larger by this factor, may be in another unit

class Shrinking {
  public:
    Shrinking(const Problem& problem, std::vector<std::string>& notes, const SceneLoading& loading)
        : problem_(problem), notes_(notes), loading_(loading) {}

    /// what: names the mesh in notes. advice: follows what a refusal says.
    ShrunkPart shrink(const Mesh& mesh, double overlap, const std::string& what,
                      const std::string& advice) const {
        ShrunkPart shrunk = [&] {
            try {
                return loading_.shrink(mesh, {overlap});
            } catch (const std::invalid_argument& error) {
                throw ArgumentError(problem_.file + ": [clearway] " + error.what() + advice);
            }
        }();
        const ThinPlaces& thin = shrunk.thin;
        if (thin.count > 0)
            notes_.push_back(fmt::format(
                "overlap = {}: {} of {} allow{} less, down to about {}, near {} (its coordinates)",
                shortNumber(overlap),
                thin.count == 1 ? "one thin place" : fmt::format("{} thin places", thin.count), what,
                thin.count == 1 ? "s" : "", roundedNumber(thin.leastOverlap), roundedPoint(thin.at)));
        return shrunk;
    }

    void shrinkInPlaceOfPart(ObstacleGroup& group, const std::string& whyPartIsOpen) const {
        const ShrunkPart shrunk =
            shrink(group.mesh, group.overlap, "the environment", openPartAdvice(whyPartIsOpen));
        const std::vector<Component> components = componentsOf(group.mesh);
        std::vector<std::uint32_t> fileTriangles;
        for (const std::uint32_t triangle : shrunk.partTriangles) {
            const std::size_t i = componentOf(components, triangle);
            fileTriangles.push_back(group.fileTriangles[i] + triangle - components[i].firstTriangle);
        }
        group.fileTriangles = std::move(fileTriangles);
        group.mesh = shrunk.mesh;
        group.solids = std::make_shared<const Solids>(Solids::oriented(group.mesh));
        group.shrunkBy = group.overlap;
    }

  private:
    const Problem& problem_;
    std::vector<std::string>& notes_;
    const SceneLoading& loading_;
};

}  // namespace

std::string unitNote(const Box& part, const Box& environment, const std::string& unit) {
    if (environment.isEmpty() || environment.min() == environment.max()) return "";
    const double ratio = part.diagonal().norm() / environment.diagonal().norm();
    if (ratio < kMostLarger && ratio > 1 / kMostSmaller) return "";
    return "the part is " + withUnit(roundedNumber(part.diagonal().norm()), unit) +
           " across and its surroundings are " +
           withUnit(roundedNumber(environment.diagonal().norm()), unit) + ": are both files in one unit?";
}

ObstacleGroups obstaclesOf(const Problem& problem, const std::vector<Mesh>& worlds) {
    requireNoGoalContact(problem);
    try {
        return groupObstacles(worlds, problem.margin, problem.rules);
    } catch (const std::invalid_argument& error) {
        throw ArgumentError(problem.file + ": [clearway] " + error.what());
    }
}

std::vector<ShrunkPart> shrinkForOverlaps(const Problem& problem, const Mesh& part, ObstacleGroups& obstacles,
                                          std::vector<std::string>& notes, const SceneLoading& loading) {
    const std::vector<double> overlaps = obstacles.overlaps();
    if (overlaps.empty()) return {};
    const Shrinking shrinking(problem, notes, loading);
    if (const MadeSolids solids = makeSolids(part); !solids.refusals.empty()) {
        for (ObstacleGroup& group : obstacles.groups) {
            if (group.overlap > 0) shrinking.shrinkInPlaceOfPart(group, solids.refusals[0]);
        }
        return {};
    }
    std::vector<ShrunkPart> all;
    for (const double overlap : overlaps) all.push_back(shrinking.shrink(part, overlap, "the part", ""));
    return all;
}

LoadedScene loadScene(const Problem& problem, const BuildOptions& options, const SceneLoading& loading) {
    return buildScene(problem, loadMeshes(problem, loading.read), options, loading);
}

LoadedScene buildScene(const Problem& problem, const SceneMeshes& meshes, const BuildOptions& options,
                       const SceneLoading& loading) {
    const Mesh& partMesh = meshes.part;
    ObstacleGroups obstacles = obstaclesOf(problem, meshes.worlds);
    const Model part = loading.build(partMesh, options, std::nullopt);
    std::optional<QueryRange> range;
    if (loading.range) range = loading.range(part, obstacles.environmentBox());
    std::vector<std::string> notes = partMesh.origin.warnings;
    for (const Mesh& world : meshes.worlds) {
        for (const std::string& warning : world.origin.warnings) notes.push_back(warning);
    }
    notes.insert(notes.end(), obstacles.notes.begin(), obstacles.notes.end());
    if (const std::string note = readingNote(problem, partMesh); !note.empty()) notes.push_back(note);
    if (const std::string note = unitNote(part.box(), obstacles.environmentBox(), problem.unit);
        !note.empty())
        notes.push_back(note + " [clearway] robot.scale and world.scale are factors for their coordinates");
    std::shared_ptr<const Solids> partSolids;
    if (obstacles.hasSolids()) {
        const MadeSolids made = makeSolids(partMesh);
        for (const std::string& refusal : made.refusals) {
            notes.push_back("part: " + refusal + "; obstacles inside it go unnoticed");
        }
        partSolids = made.solids;
    }
    std::vector<std::shared_ptr<const ShrunkModel>> shrunk;
    for (const ShrunkPart& each : shrinkForOverlaps(problem, partMesh, obstacles, notes, loading)) {
        shrunk.push_back(shrunkModel(each, loading.build(each.mesh, options, std::nullopt)));
    }
    Scene scene = makeScene(
        part, partSolids, obstacles, problem.rules, poseOf(problem.start), poseOf(problem.goal),
        [&](const Mesh& mesh) { return loading.build(mesh, options, range); }, shrunk);
    scene.unit = problem.unit;
    return {std::move(scene), notes};
}

}  // namespace clearway
