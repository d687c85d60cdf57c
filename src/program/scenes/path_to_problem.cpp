#include "program/scenes/path_to_problem.h"

namespace clearway::scenes {

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

}  // namespace clearway::scenes
