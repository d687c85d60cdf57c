// The module clearway for Python, without OMPL: its queries, and what the other sources bind. python/clearway/_core.pyi has the types.
#include <fmt/format.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "clearway/batch.h"
#include "clearway/model.h"
#include "clearway/query.h"
#include "clearway/targets.h"
#include "clearway/version.h"
#include "python/arrays.h"
#include "python/bindings.h"
#include "python/released_gil.h"

namespace clearway::python {
namespace {

/// The given workspace or, for None, that of the calling thread.
Workspace& chosen(OwnedWorkspace* workspace) {
    thread_local Workspace workspaceOfThread;
    return workspace ? workspace->mine() : workspaceOfThread;
}

DistanceOptions optionsOf(double relativeError, double absoluteError, double cap) {
    DistanceOptions options;
    options.relativeError = relativeError;
    options.absoluteError = absoluteError;
    options.cap = cap;
    return options;
}

std::string describe(const DistanceResult& result) {
    return fmt::format(
        "DistanceResult(lower={:.17g}, upper={:.17g}, part_triangle={}, environment_triangle={})",
        result.lower, result.upper, result.partTriangle, result.environmentTriangle);
}

/// (N, 3).
py::array_t<double> pointsOf(const std::vector<DistanceResult>& results, Vector3 DistanceResult::*member) {
    py::array_t<double> column({static_cast<py::ssize_t>(results.size()), py::ssize_t{3}});
    for (std::size_t i = 0; i < results.size(); ++i) {
        for (int axis = 0; axis < 3; ++axis) column.mutable_at(i, axis) = (results[i].*member)[axis];
    }
    return column;
}

/// The results of many poses, as arrays.
py::dict arraysOf(const std::vector<DistanceResult>& results) {
    py::dict arrays;
    arrays["lower"] = columnOf<double>(results, &DistanceResult::lower);
    arrays["upper"] = columnOf<double>(results, &DistanceResult::upper);
    arrays["distance"] = columnOf<double>(results, &DistanceResult::distance);
    arrays["point_on_part"] = pointsOf(results, &DistanceResult::pointOnPart);
    arrays["point_on_environment"] = pointsOf(results, &DistanceResult::pointOnEnvironment);
    arrays["part_triangle"] = columnOf<std::int64_t>(results, &DistanceResult::partTriangle);
    arrays["environment_triangle"] = columnOf<std::int64_t>(results, &DistanceResult::environmentTriangle);
    return arrays;
}

void bindQueries(py::module_& module) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    py::class_<OwnedWorkspace>(
        module, "Workspace",
        R"(The scratch memory and the warm start of the thread that makes it. Other threads are refused.)")
        .def(py::init<>())
        .def(
            "forget_warm_start", [](OwnedWorkspace& workspace) { workspace.mine().forgetWarmStart(); },
            R"(Makes the next answer independent, to the last digit, of what was asked before.)");
    py::class_<DistanceResult>(
        module, "DistanceResult",
        R"(lower <= true distance <= upper; both are 0 on contact. Lengths are in environment units, points (3,) in the
environment's frame; triangles count as in the mesh. Beyond the cap upper and distance are inf, triangles -1, points nan.)")
        .def_readonly("lower", &DistanceResult::lower, R"(No more than the true distance.)")
        .def_readonly("upper", &DistanceResult::upper,
                      R"(No less than the true distance; inf beyond the cap.)")
        .def_readonly("distance", &DistanceResult::distance,
                      R"(The distance of the two points; 0 on contact.)")
        .def_readonly("point_on_part", &DistanceResult::pointOnPart,
                      R"((3,): the part's point of the closest pair, environment frame.)")
        .def_readonly("point_on_environment", &DistanceResult::pointOnEnvironment,
                      R"((3,): the environment's point of the closest pair, environment frame.)")
        .def_readonly("part_triangle", &DistanceResult::partTriangle,
                      R"(The row of the part's triangles that has the point; -1 beyond the cap.)")
        .def_readonly("environment_triangle", &DistanceResult::environmentTriangle,
                      R"(The row of the environment's triangles that has the point; -1 beyond the cap.)")
        .def_property_readonly("collides", &DistanceResult::collides,
                               R"(Whether the two share a point, exactly.)")
        .def("__repr__", &describe);
    module.def(
        "distance",
        [](const Model& part, const Model& environment, const Pose& pose, OwnedWorkspace* workspace,
           double relativeError, double absoluteError, double cap) {
            return distance(part, environment, pose, optionsOf(relativeError, absoluteError, cap),
                            chosen(workspace));
        },
        py::arg("part"), py::arg("environment"), py::arg("pose"), py::arg("workspace") = py::none(),
        py::kw_only(), py::arg("relative_error") = 0.0, py::arg("absolute_error") = 0.0,
        py::arg("cap") = kInfinity, WithoutGil(),
        R"(The distance of the part at the pose from the environment. pose: (4, 4), X_environment_part. The interval may be as
wide as the larger of absolute_error, relative_error * lower and rounding; distances above the cap do not matter.)");
    module.def(
        "collides",
        [](const Model& part, const Model& environment, const Pose& pose, OwnedWorkspace* workspace) {
            return collides(part, environment, pose, chosen(workspace));
        },
        py::arg("part"), py::arg("environment"), py::arg("pose"), py::arg("workspace") = py::none(),
        WithoutGil(),
        R"(Whether the part at the pose and the environment share a point, exactly. pose: (4, 4).)");
    module.def(
        "is_within",
        [](const Model& part, const Model& environment, const Pose& pose, double d,
           OwnedWorkspace* workspace) { return isWithin(part, environment, pose, d, chosen(workspace)); },
        py::arg("part"), py::arg("environment"), py::arg("pose"), py::arg("d"),
        py::arg("workspace") = py::none(), WithoutGil(),
        R"(Whether the distance is <= d, exactly. pose: (4, 4). d: environment units, >= 0.)");
    module.def(
        "distance_batch",
        [](const Model& part, const Model& environment, const std::vector<Pose>& poses, double relativeError,
           double absoluteError, double cap) {
            const DistanceOptions options = optionsOf(relativeError, absoluteError, cap);
            return arraysOf(withoutGil([&] { return distanceBatch(part, environment, poses, options); }));
        },
        py::arg("part"), py::arg("environment"), py::arg("poses"), py::kw_only(),
        py::arg("relative_error") = 0.0, py::arg("absolute_error") = 0.0, py::arg("cap") = kInfinity,
        R"(distance() for poses (N, 4, 4), on all cores. Returns a dict of arrays, named as DistanceResult's attributes: lengths
and ids (N,), points (N, 3). Order the poses as along a path.)");
    module.def(
        "is_within_batch",
        [](const Model& part, const Model& environment, const std::vector<Pose>& poses, double d) {
            return flagsOf(withoutGil([&] { return isWithinBatch(part, environment, poses, d); }));
        },
        py::arg("part"), py::arg("environment"), py::arg("poses"), py::arg("d"),
        R"(is_within() for poses (N, 4, 4), on all cores; d = 0 asks for contact. Returns (N,) bools.)");
    module.def(
        "pose_from",
        [](const std::vector<double>& position, const std::vector<double>& quaternion) {
            if (position.size() != 3 || quaternion.size() != 4) {
                throw std::invalid_argument(
                    fmt::format("position and quaternion have {} and {} numbers, expected 3 and 4",
                                position.size(), quaternion.size()));
            }
            return toPose(Eigen::Quaterniond(quaternion[3], quaternion[0], quaternion[1], quaternion[2]),
                          Vector3(position[0], position[1], position[2]));
        },
        py::arg("position"), py::arg("quaternion"),
        R"(The (4, 4) pose of a position (x, y, z) and a quaternion (x, y, z, w), which is normalised first.)");
    module.def(
        "nearest_pose",
        [](const py::object& matrix) { return nearestPose(upperRowsOf(matrixOf(matrix, "matrix").data())); },
        py::arg("matrix"),
        R"(The pose whose rotation is nearest to the matrix's, for rotations with few digits: off by at most 1e-5. (4, 4) to (4, 4).)");
    module.def("available_targets", &availableTargets,
               R"(The instruction sets that queries can run on here, best first.)");
    module.def("current_target", &currentTarget, R"(The instruction set that queries run on.)");
    module.def("use_target", &useTarget, py::arg("name"),
               R"(Runs later queries on this instruction set; "best" returns to the default.)");
}

}  // namespace
}  // namespace clearway::python

PYBIND11_MODULE(_core, module) {
    namespace py = pybind11;
    module.attr("__version__") = CLEARWAY_VERSION;
    // As for io.UnsupportedOperation, a file that cannot be used is wrong as a value and as a file.
    const py::object bases = py::make_tuple(py::reinterpret_borrow<py::object>(PyExc_OSError),
                                            py::reinterpret_borrow<py::object>(PyExc_ValueError));
    static py::handle fileError = PyErr_NewException("clearway.FileError", bases.ptr(), nullptr);
    module.attr("FileError") = fileError;
    py::register_exception_translator([](std::exception_ptr thrown) {
        try {
            if (thrown) std::rethrow_exception(thrown);
        } catch (const py::builtin_exception&) {
            throw;
        } catch (const py::error_already_set&) {
            throw;
        } catch (const std::bad_alloc&) {
            throw;
        } catch (const std::runtime_error& error) {
            PyErr_SetString(fileError.ptr(), error.what());
        }
    });
    clearway::python::bindMeshesAndModels(module);
    clearway::python::bindQueries(module);
    clearway::python::bindProblems(module);
    clearway::python::bindScenes(module);
    clearway::python::bindStates(module);
    clearway::python::RunningWork::watchPython();
}
