#include "program/study/study_problem.h"

#include "clearway/planning/plan.h"
#include "core/number.h"

namespace clearway::study {
namespace {

Model build(const Mesh& mesh, const Engine& engine, const std::string& cache,
            const std::optional<Reach>& reach = std::nullopt) {
    if (cache.empty()) return Model::build(mesh, engine.build, reach);
    return buildCached(mesh, engine.build, cache, reach).model;
}

Box boxOf(const ObstacleGroups& obstacles) {
    Box box = obstacles.ignoredBox;
    for (const ObstacleGroup& group : obstacles.groups) box.extend(boundingBox(group.mesh));
    return box;
}

/// The same wherever the mesh's file lies, and however its name was given.
std::string keyOf(Mesh mesh) {
    mesh.origin.file.clear();
    return std::to_string(modelKey(mesh, {}));
}

std::string textOf(const PartState& state) {
    std::string text;
    for (int i = 0; i < 3; ++i) text += " " + formatNumber(state.position[i]);
    for (int i = 0; i < 4; ++i) text += " " + formatNumber(state.rotation.coeffs()[i]);
    return text;
}

}  // namespace

std::size_t StudyProblem::environmentTriangles() const {
    std::size_t count = 0;
    for (const ObstacleGroup& group : obstacles.groups) count += group.mesh.triangles.size();
    return count;
}

std::string StudyProblem::fingerprint() const {
    std::string text = keyOf(part);
    for (const ObstacleGroup& group : obstacles.groups) {
        text += " " + keyOf(group.mesh) + " " + formatNumber(group.margin) + " " +
                std::to_string(group.isIgnoredAtStart) + std::to_string(group.isIgnoredAtGoal) +
                std::to_string(group.solids != nullptr);
    }
    for (const PlannerChoice& choice : problem.planners) {
        for (const NamedTexts* texts : {&choice.parameters, &choice.settings}) {
            for (const auto& [key, value] : *texts) text += " " + choice.name + "." + key + "=" + value;
        }
    }
    for (const auto& [key, value] : problem.settings) text += " " + key + "=" + value;
    const Box bounds = boundsOf(problem, boxOf(obstacles));
    text += textOf(problem.start) + textOf(problem.goal);
    for (const Vector3& corner : {bounds.min(), bounds.max()}) {
        for (int i = 0; i < 3; ++i) text += " " + formatNumber(corner[i]);
    }
    return text;
}

Scene buildScene(const StudyProblem& study, const Engine& engine, const std::string& cache) {
    const Model part = build(study.part, engine, cache);
    planning::PlanOptions reaching;
    reaching.objective = "max_min_clearance";
    const auto reach = planning::planningReach(study.problem, reaching, part, boxOf(study.obstacles));
    return makeScene(part, study.partSolids, study.obstacles, study.problem.rules,
                     poseOf(study.problem.start), poseOf(study.problem.goal),
                     [&](const Mesh& mesh) { return build(mesh, engine, cache, reach); });
}

}  // namespace clearway::study
