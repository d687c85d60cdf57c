#include "program/report/obstacle_clearances.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>
#include <unordered_map>

#include "core/parallel.h"
#include "mesh/components.h"
#include "model/solids.h"
#include "model/triangles_of.h"
#include "problem/outside.h"

namespace clearway::report {

namespace {

Box boxOfComponent(const Mesh& mesh, const Component& component) {
    Box box;
    for (std::uint32_t i = 0; i < component.triangleCount; ++i) {
        for (const std::uint32_t vertex : mesh.triangles[component.firstTriangle + i])
            box.extend(mesh.vertices[vertex]);
    }
    return box;
}

/// The component of the model, as far as the model holds it.
Mesh meshOf(const Model& model, std::size_t component) {
    Mesh mesh;
    mesh.components = {{model.components()[component].name, 0, 0}};
    eachTriangleOf(model, [&](std::size_t i, const TriangleCorners& corners) {
        if (i != component) return;
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), corners.begin(), corners.end());
        mesh.triangles.push_back({first, first + 1, first + 2});
    });
    mesh.components[0].triangleCount = static_cast<std::uint32_t>(mesh.triangles.size());
    return mesh;
}

/// Measures one component after another.
class Measuring {
  public:
    Measuring(const Scene& scene, const Mesh& environment, const std::vector<ReportFrame>& frames)
        : scene_(scene), environment_(environment), frames_(frames) {
        for (const ReportFrame& frame : frames)
            partBoxes_.push_back(movedBox(frame.X_environmentPart, scene.part.box()));
        for (std::size_t i = 0; i < scene.obstacles.size(); ++i) {
            for (const Component& component : scene.obstacles[i].model.components())
                obstacleOf_.try_emplace(component.name, i);
        }
    }

    const Obstacle* obstacleOf(const Component& component) const {
        const auto found = obstacleOf_.find(component.name);
        return found == obstacleOf_.end() ? nullptr : &scene_.obstacles[found->second];
    }

    /// Lower bounds of the distances at the frames within range, with their frames, the least first.
    std::vector<std::pair<double, std::size_t>> boxDistances(const Component& component) const {
        const Box box = boxOfComponent(environment_, component);
        std::vector<std::pair<double, std::size_t>> distances;
        for (std::size_t i = 0; i < frames_.size(); ++i) {
            if (frames_[i].isInRange) distances.emplace_back(box.exteriorDistance(partBoxes_[i]), i);
        }
        std::sort(distances.begin(), distances.end());
        return distances;
    }

    void measure(std::size_t index, const Component& component, ObstacleClearance& answer) const {
        const std::optional<Scene> scene = sceneOf(index, *obstacleOf(component));
        if (!scene) return;
        const SceneClearance clearance(*scene);
        answer = {};
        answer.margin = clearance.scene().obstacles[0].margin;
        answer.isMeasured = answer.isInScene = true;
        for (const auto& [boxDistance, frame] : boxDistances(component)) {
            if (boxDistance - answer.margin >= answer.lower) break;
            ClearanceOptions options;
            options.cap = answer.lower;
            const Pose& X_environmentPart = frames_[frame].X_environmentPart;
            const PoseClearance found = clearance.at(X_environmentPart, options);
            if (!(found.lower < answer.lower)) continue;
            answer.lower = found.lower;
            answer.frame = frame;
            answer.trouble = clearance.whyInvalid(X_environmentPart, found).kind;
        }
    }

  private:
    std::size_t ownIndexOf(const Model& model, std::size_t index) const {
        const std::string name = componentsOf(environment_)[index].name;
        const auto& own = model.components();
        return static_cast<std::size_t>(
            std::find_if(own.begin(), own.end(), [&](const Component& each) { return each.name == name; }) -
            own.begin());
    }

    /// The scene with one component of an obstacle, which counts as the obstacle does; none if the model does not hold it.
    std::optional<Scene> sceneOf(std::size_t index, const Obstacle& obstacle) const {
        Scene single(scene_.part);
        single.partSolids = scene_.partSolids;
        single.startContact = scene_.startContact;
        single.goalContact = scene_.goalContact;
        single.obstacles = {obstacle};
        if (obstacle.model.components().size() == 1) return single;
        const bool isShrunk = obstacle.shrunkBy > 0;
        const std::size_t own = isShrunk ? ownIndexOf(obstacle.model, index) : 0;
        const Mesh mesh = isShrunk ? meshOf(obstacle.model, own) : meshOfComponents(environment_, {index});
        if (mesh.triangles.empty()) return std::nullopt;
        Obstacle& made = single.obstacles[0];
        made.model = Model::build(mesh, obstacle.model.report().options);
        made.fileTriangles.clear();
        if (isShrunk) {
            made.solids = std::make_shared<const Solids>(obstacle.solids->ofComponent(own));
        } else if (obstacle.solids) {
            made.solids = makeSolids(mesh).solids;
        }
        return single;
    }

    const Scene& scene_;
    const Mesh& environment_;
    const std::vector<ReportFrame>& frames_;
    std::vector<Box> partBoxes_;
    std::unordered_map<std::string, std::size_t> obstacleOf_;
};

}  // namespace

std::vector<ObstacleClearance> obstacleClearances(const Scene& scene, const Mesh& environment,
                                                  const std::vector<ReportFrame>& frames, std::size_t most) {
    const Measuring measuring(scene, environment, frames);
    const std::vector<Component> components = componentsOf(environment);
    std::vector<ObstacleClearance> answers(components.size());
    std::vector<std::size_t> nearestFirst;
    for (std::size_t i = 0; i < components.size(); ++i) {
        const Obstacle* obstacle = measuring.obstacleOf(components[i]);
        if (!obstacle || components[i].triangleCount == 0) continue;
        answers[i].isInScene = true;
        answers[i].margin = obstacle->margin;
        const auto distances = measuring.boxDistances(components[i]);
        if (!distances.empty()) answers[i].lower = distances.front().first - obstacle->margin;
        nearestFirst.push_back(i);
    }
    std::stable_sort(nearestFirst.begin(), nearestFirst.end(),
                     [&](std::size_t a, std::size_t b) { return answers[a].lower < answers[b].lower; });
    nearestFirst.resize(std::min(most, nearestFirst.size()));
    forEachInParallel(nearestFirst.size(), [&](std::size_t k) {
        const std::size_t i = nearestFirst[k];
        measuring.measure(i, components[i], answers[i]);
    });
    for (std::size_t i = 0; i < answers.size(); ++i) {
        if (!answers[i].isInScene) continue;
        answers[i].isLeftOutAtStart = measuring.obstacleOf(components[i])->isIgnoredAtStart;
        answers[i].isLeftOutAtGoal = measuring.obstacleOf(components[i])->isIgnoredAtGoal;
    }
    return answers;
}

}  // namespace clearway::report
