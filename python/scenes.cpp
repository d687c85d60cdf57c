// Scenes for Python: a part among obstacles with margins, at a pose and along a motion.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "clearway/build_options.h"
#include "clearway/errors.h"
#include "clearway/problem.h"
#include "clearway/scene_clearance.h"
#include "python/arrays.h"
#include "python/bindings.h"
#include "python/released_gil.h"
#include "python/scenes.h"

namespace clearway::python {
namespace {

struct PyObstacle {
    Obstacle obstacle;
};

PyObstacle makeObstacle(const Model& model, double margin, const Mesh* solid) {
    PyObstacle made{{model, margin}};
    if (!solid) return made;
    const MadeSolids solids = makeSolids(*solid);
    if (!solids.refusals.empty()) throw ArgumentError("solid: " + solids.refusals.front());
    made.obstacle.solids = solids.solids;
    return made;
}

std::unique_ptr<PyScene> makeScene(const Model& part, const std::vector<PyObstacle>& obstacles,
                                   const Mesh* partMesh) {
    Scene scene(part);
    for (const PyObstacle& made : obstacles) scene.obstacles.push_back(made.obstacle);
    std::vector<std::string> notes;
    if (partMesh) {
        const MadeSolids made = makeSolids(*partMesh);
        for (const std::string& refusal : made.refusals) {
            notes.push_back("part: " + refusal + "; obstacles inside it go unnoticed");
        }
        scene.partSolids = made.solids;
    }
    return std::make_unique<PyScene>(std::move(scene), std::move(notes));
}

std::unique_ptr<PyScene> loadSceneOf(const py::object& given, const std::string& preset, int threads) {
    const Problem problem = problemOf(given);
    requireMeshFiles(problem);
    requirePreset(preset);
    BuildOptions options;
    options.threads = threads;
    const ReleasedGil released;
    LoadedScene loaded = loadScene(problem, options);
    return std::make_unique<PyScene>(std::move(loaded.scene), std::move(loaded.notes));
}

std::vector<PyObstacle> obstaclesOf(const PyScene& scene) {
    std::vector<PyObstacle> obstacles;
    for (const Obstacle& obstacle : scene.clearance.scene().obstacles) obstacles.push_back({obstacle});
    return obstacles;
}

py::tuple checkMotion(const PyScene& scene, const py::object& from, const py::object& to) {
    const RigidMotion motion = motionBetween(poseOf(from, "start"), poseOf(to, "end"));
    const MotionAnswer found = withoutGil([&] { return scene.clearance.check(motion); });
    const char* names[] = {"certified", "contact", "undecided"};
    return py::make_tuple(names[static_cast<int>(found.verdict)], found.certifiedUntil, found.contactTime);
}

void bindObstacle(py::module_& module) {
    py::class_<PyObstacle>(module, "Obstacle",
                           R"(A model that the part of a scene must stay away from. Immutable.)")
        .def(
            py::init(&makeObstacle), py::arg("model"), py::arg("margin") = 0.0, py::kw_only(),
            py::arg("solid") = py::none(),
            R"(Must stay farther from the part than the margin (environment units). solid: the model's closed mesh; the part is then
not free inside of it either.)")
        .def_property_readonly(
            "model", [](const PyObstacle& obstacle) { return obstacle.obstacle.model; },
            R"(The obstacle's model, in the environment's frame.)")
        .def_property_readonly(
            "margin", [](const PyObstacle& obstacle) { return obstacle.obstacle.margin; },
            R"(The distance that the part must exceed, environment units.)")
        .def_property_readonly(
            "is_solid", [](const PyObstacle& obstacle) { return obstacle.obstacle.solids != nullptr; },
            R"(Whether the inside of the obstacle counts too.)")
        .def("__repr__", [](const PyObstacle& obstacle) {
            return py::str("Obstacle({} triangles, margin {!r})")
                .format(obstacle.obstacle.model.report().triangles, obstacle.obstacle.margin);
        });
}

/// A triangle of the closest pair, where that is the reason.
template <std::int64_t Witness::*kTriangle>
std::optional<std::int64_t> triangleOf(const WhyInvalid& why) {
    if (!why.nearest.witness) return std::nullopt;
    return (*why.nearest.witness).*kTriangle;
}

void bindWhyInvalid(py::module_& module) {
    py::class_<WhyInvalid>(
        module, "WhyInvalid",
        R"(What is wrong with a pose. str() is the reason in words, after "is"; false when nothing is wrong.)")
        .def_property_readonly(
            "kind", [](const WhyInvalid& why) { return nameOf(why.kind); },
            R"("valid", "collides", "too deep", "inside a solid", "too close", "out of range" or "unusable".)")
        .def_readonly("obstacle", &WhyInvalid::obstacle,
                      R"(Index into Scene.obstacles; None unless an obstacle is the reason.)")
        .def_readonly("part_mesh", &WhyInvalid::partMesh, R"(Name of the part's mesh, or "".)")
        .def_readonly("environment_mesh", &WhyInvalid::environmentMesh,
                      R"(Name of the obstacle's mesh, or "".)")
        .def_property_readonly(
            "part_triangle", &triangleOf<&Witness::partTriangle>,
            R"(Position in the part's mesh; None where no pair of triangles is the reason.)")
        .def_property_readonly("environment_triangle", &triangleOf<&Witness::environmentTriangle>,
                               R"(Position in the obstacle's file, or None.)")
        .def_readonly(
            "limit", &WhyInvalid::limit,
            R"(The distance to exceed or, of "too deep", the depth that is allowed; environment units.)")
        .def("__repr__",
             [](const WhyInvalid& why) {
                 return py::str("WhyInvalid({!r}, {!r})").format(nameOf(why.kind), why.words());
             })
        .def("__str__", &WhyInvalid::words)
        .def("__bool__", [](const WhyInvalid& why) { return !why.isValid(); });
}

}  // namespace

void bindScenes(py::module_& module) {
    bindObstacle(module);
    bindWhyInvalid(module);
    py::class_<PyScene>(
        module, "Scene",
        R"(One part among obstacles with margins. Immutable; any number of threads may ask one scene. Poses are (4, 4),
X_environment_part; lengths are in the environment's unit.)")
        .def(
            py::init(&makeScene), py::arg("part"), py::arg("obstacles"), py::kw_only(),
            py::arg("part_mesh") = py::none(),
            R"(One part among obstacles. part_mesh: the part's closed mesh, needed when an obstacle is solid; `notes` names its components
that are not closed.)")
        .def_static(
            "load", &loadSceneOf, py::arg("problem"), py::kw_only(), py::arg("preset") = "best",
            py::arg("threads") = 0,
            R"(Loads the meshes of a Problem, or of a problem file, and builds their models, with the problem's margins and rules.
preset: as for Model. threads: 0 for all cores.)")
        .def_property_readonly(
            "part", [](const PyScene& scene) { return scene.clearance.scene().part; }, R"(The part's model.)")
        .def_property_readonly("obstacles", &obstaclesOf,
                               R"(The obstacles; each has components that share a margin.)")
        .def_readonly("notes", &PyScene::notes,
                      R"(What loading did to the meshes, and what looks wrong about them, one line each.)")
        .def(
            "is_free", [](const PyScene& scene, const Pose& pose) { return scene.clearance.isFree(pose); },
            py::arg("pose"), WithoutGil(),
            R"(Whether all distances are larger than the margins, and the part is in no solid. pose: (4, 4).)")
        .def(
            "is_free_batch",
            [](const PyScene& scene, const std::vector<Pose>& poses) {
                return flagsOf(withoutGil([&] { return scene.clearance.isFreeBatch(poses); }));
            },
            py::arg("poses"),
            R"(is_free() for poses (N, 4, 4), on all cores. Returns (N,) bools. Order the poses as along a path.)")
        .def(
            "clearance",
            [](const PyScene& scene, const Pose& pose) { return scene.clearance.at(pose).lower; },
            py::arg("pose"), WithoutGil(),
            R"(The least distance less margin, a lower bound; above 0 exactly when the pose is free; inf without obstacles.)")
        .def(
            "clearance_batch",
            [](const PyScene& scene, const std::vector<Pose>& poses) {
                return arrayOf(withoutGil([&] { return scene.clearance.clearanceBatch(poses); }));
            },
            py::arg("poses"),
            R"(clearance() for poses (N, 4, 4), on all cores. Returns (N,) doubles. Order the poses as along a path.)")
        .def(
            "why_not_free",
            [](const PyScene& scene, const Pose& pose) { return scene.clearance.whyInvalid(pose).words(); },
            py::arg("pose"), WithoutGil(),
            R"(str() of why_invalid(): why the pose is not free, as words after "is"; empty when it is.)")
        .def(
            "why_invalid",
            [](const PyScene& scene, const Pose& pose) { return scene.clearance.whyInvalid(pose); },
            py::arg("pose"), WithoutGil(), R"(Why the pose is not free, as a WhyInvalid.)")
        .def(
            "escape_distance",
            [](const PyScene& scene, const Pose& pose, const Vector3& direction) {
                const EscapeDistance found = scene.clearance.escapeDistance(pose, direction);
                return std::pair(found.lower, found.upper);
            },
            py::arg("pose"), py::arg("direction"), WithoutGil(),
            R"(How far the part must be moved in a direction (3,) to be free, however far it is moved on: (lower, upper). Moved by `upper`
or more it is free; `lower` is 0 or a length at which it is not.)")
        .def(
            "check_motion", &checkMotion, py::arg("start"), py::arg("end"),
            R"(Checks the straight motion with the shorter turn between two poses (4, 4), however thin an obstacle is. Returns
(verdict, certified_until, contact_time): "certified", "contact" or "undecided" (too close to a margin to tell), the time up
to which it is free, of 0 to 1, and that of a pose that is not (None for none). A half turn is taken either way.)")
        .def("__repr__", [](const PyScene& scene) {
            return "Scene(" + std::to_string(scene.clearance.scene().obstacles.size()) + " obstacles)";
        });
}

}  // namespace clearway::python
