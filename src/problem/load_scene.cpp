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

    ShrunkPart shrinkPart(const Mesh& part, double overlap) const {
        ShrunkPart shrunk = shrink(part, overlap);
        tell(overlap, shrunk.thin, "the part");
        return shrunk;
    }

    /// Shrinks each closed component of the groups with an overlap by itself, so that obstacles which touch each other do not hinder it.
    /// Open components get no overlap. Throws if there are only such.
    void shrinkInPlaceOfPart(ObstacleGroups& obstacles, const std::string& whyPartIsOpen) const {
        std::vector<ObstacleGroup> groups;
        std::vector<std::string> refusals;
        bool isAnyShrunk = false;
        for (const ObstacleGroup& group : obstacles.groups) {
            if (group.overlap == 0) {
                groups.push_back(group);
                continue;
            }
            obstacles.ignoredBox.extend(boundingBox(group.mesh));  // a goal outside means the whole obstacles
            auto [closed, open] = divided(group, refusals);
            isAnyShrunk = isAnyShrunk || !closed.mesh.triangles.empty();
            if (!closed.mesh.triangles.empty()) groups.push_back(std::move(closed));
            if (!open.mesh.triangles.empty()) groups.push_back(std::move(open));
        }
        if (!refusals.empty()) {
            const std::string others =
                refusals.size() == 1 ? "" : fmt::format("; {} more obstacles are open", refusals.size() - 1);
            const std::string advice = refusals[0] + others + openPartAdvice(whyPartIsOpen);
            if (!isAnyShrunk) throw ArgumentError(problem_.file + ": [clearway] overlap: " + advice);
            notes_.push_back("no overlap for an open obstacle: " + advice);
        }
        obstacles.groups = std::move(groups);
    }

  private:
    struct Divided {
        ObstacleGroup closed, open;
    };

    ShrunkPart shrink(const Mesh& mesh, double overlap) const {
        try {
            return loading_.shrink(mesh, {overlap});
        } catch (const std::invalid_argument& error) {
            throw ArgumentError(problem_.file + ": [clearway] " + error.what());
        }
    }

    /// what: names what is thin.
    void tell(double overlap, const ThinPlaces& thin, const char* what) const {
        if (thin.count == 0) return;
        notes_.push_back(
            fmt::format("overlap = {}: {} of {} allow{} less, down to about {}, near {} (its coordinates)",
                        shortNumber(overlap),
                        thin.count == 1 ? "one thin place" : fmt::format("{} thin places", thin.count), what,
                        thin.count == 1 ? "s" : "", roundedNumber(thin.leastOverlap), roundedPoint(thin.at)));
    }

    /// The closed components, shrunk, and the open ones, each group perhaps without any. refusals: adds why components are open.
    Divided divided(const ObstacleGroup& group, std::vector<std::string>& refusals) const {
        // No point inside a component is deeper than this share of its diagonal.
        constexpr double kMost = 0.49;
        Divided made{group, group};
        made.closed.mesh = Mesh();
        made.closed.mesh.origin = group.mesh.origin;
        made.closed.fileTriangles.clear();
        made.open.fileTriangles.clear();
        ThinPlaces thin;
        thin.leastOverlap = group.overlap;
        std::vector<std::size_t> open;
        const std::vector<Component> components = componentsOf(group.mesh);
        for (std::size_t i = 0; i < components.size(); ++i) {
            if (components[i].triangleCount == 0) continue;
            const Mesh one = meshOfComponents(group.mesh, {i});
            if (const MadeSolids solids = makeSolids(one); !solids.refusals.empty()) {
                refusals.push_back(solids.refusals[0]);
                open.push_back(i);
                made.open.fileTriangles.push_back(group.fileTriangles[i]);
                continue;
            }
            const ShrunkPart shrunk =
                shrink(one, std::min(group.overlap, kMost * boundingBox(one).diagonal().norm()));
            append(shrunk.mesh, components[i].name, made.closed.mesh);
            for (const std::uint32_t triangle : shrunk.partTriangles)
                made.closed.fileTriangles.push_back(group.fileTriangles[i] + triangle);
            thin.count += shrunk.thin.count;
            if (shrunk.thin.count == 0 || shrunk.thin.leastOverlap >= thin.leastOverlap) continue;
            thin.leastOverlap = shrunk.thin.leastOverlap;
            thin.at = shrunk.thin.at;
        }
        tell(group.overlap, thin, "obstacles");
        if (!made.closed.mesh.triangles.empty())
            made.closed.solids = std::make_shared<const Solids>(Solids::oriented(made.closed.mesh));
        made.closed.shrunkBy = group.overlap;
        made.open.mesh = meshOfComponents(group.mesh, open);
        made.open.overlap = 0;
        if (!open.empty()) made.open.solids = makeSolids(made.open.mesh).solids;
        return made;
    }

    static void append(const Mesh& component, const std::string& name, Mesh& to) {
        const auto firstVertex = static_cast<std::uint32_t>(to.vertices.size());
        to.components.push_back({name, static_cast<std::uint32_t>(to.triangles.size()),
                                 static_cast<std::uint32_t>(component.triangles.size())});
        to.vertices.insert(to.vertices.end(), component.vertices.begin(), component.vertices.end());
        for (TriangleIndices triangle : component.triangles) {
            for (std::uint32_t& vertex : triangle) vertex += firstVertex;
            to.triangles.push_back(triangle);
        }
    }

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
        shrinking.shrinkInPlaceOfPart(obstacles, solids.refusals[0]);
        return {};
    }
    std::vector<ShrunkPart> all;
    for (const double overlap : overlaps) all.push_back(shrinking.shrinkPart(part, overlap));
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
        if (problem.rules.isAllSolid || !problem.rules.solid.empty()) {
            for (const std::string& refusal : made.refusals)
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
