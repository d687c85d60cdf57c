// Scenes for Python: a part among obstacles with margins, at a pose and along a motion.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "clearway/scene_clearance.h"
#include "python/arrays.h"
#include "python/bindings.h"

namespace clearway::python {
namespace {

using ReleasedGil = py::gil_scoped_release;

struct PyObstacle {
    Obstacle obstacle;
};

PyObstacle makeObstacle(const Model& model, double margin, const Mesh* solid) {
    PyObstacle made{{model, margin}};
    if (!solid) return made;
    const MadeSolids solids = makeSolids(*solid);
    if (!solids.refusals.empty()) throw std::invalid_argument("solid: " + solids.refusals.front());
    made.obstacle.solids = solids.solids;
    return made;
}

std::unique_ptr<SceneClearance> makeScene(const Model& part, const std::vector<PyObstacle>& obstacles,
                                          const Mesh* partMesh) {
    Scene scene(part);
    for (const PyObstacle& made : obstacles) scene.obstacles.push_back(made.obstacle);
    if (partMesh) scene.partSolids = makeSolids(*partMesh).solids;
    return std::make_unique<SceneClearance>(std::move(scene));
}

py::tuple checkMotion(const SceneClearance& scene, const py::object& from, const py::object& to) {
    const RigidMotion motion = motionBetween(poseOf(from, "start"), poseOf(to, "end"));
    MotionAnswer found;
    {
        const ReleasedGil released;
        found = scene.check(motion);
    }
    const char* names[] = {"certified", "contact", "undecided"};
    return py::make_tuple(names[static_cast<int>(found.verdict)], found.certifiedUntil, found.contactTime);
}

}  // namespace

void bindScenes(py::module_& module) {
    py::class_<PyObstacle>(module, "Obstacle")
        .def(
            py::init(&makeObstacle), py::arg("model"), py::arg("margin") = 0.0, py::kw_only(),
            py::arg("solid") = py::none(),
            R"(Must stay farther from the part than the margin (environment units). solid: the model's closed mesh; the part is then
not free inside of it either.)");
    py::class_<SceneClearance>(module, "Scene")
        .def(
            py::init(&makeScene), py::arg("part"), py::arg("obstacles"), py::kw_only(),
            py::arg("part_mesh") = py::none(),
            R"(One part among obstacles. part_mesh: the part's closed mesh, needed when an obstacle is solid.)")
        .def(
            "is_free",
            [](const SceneClearance& scene, const py::object& pose) {
                const Pose X = poseOf(pose);
                const ReleasedGil released;
                return scene.isFree(X);
            },
            py::arg("pose"),
            R"(Whether all distances are larger than the margins, and the part is in no solid. pose: (4, 4).)")
        .def(
            "clearance",
            [](const SceneClearance& scene, const py::object& pose) {
                const Pose X = poseOf(pose);
                const ReleasedGil released;
                return scene.at(X).lower;
            },
            py::arg("pose"),
            R"(The least distance less margin, a lower bound; above 0 exactly when the pose is free; inf without obstacles.)")
        .def(
            "why_not_free",
            [](const SceneClearance& scene, const py::object& pose) {
                const Pose X = poseOf(pose);
                const ReleasedGil released;
                return scene.whyInvalid(X);
            },
            py::arg("pose"), R"(Why the pose is not free, as words after "is"; empty when it is.)")
        .def(
            "check_motion", &checkMotion, py::arg("start"), py::arg("end"),
            R"(Checks the straight motion with the shorter turn between two poses (4, 4), however thin an obstacle is. Returns
(verdict, certified_until, contact_time): "certified", "contact" or "undecided" (too close to a margin to tell), the time up
to which it is free, of 0 to 1, and that of a pose that is not (inf for none). A half turn is taken either way.)");
}

}  // namespace clearway::python
