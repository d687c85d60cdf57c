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
#include "clearway/errors.h"
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
    const Witness witness = witnessOf(result);
    return fmt::format(
        "DistanceResult(lower={:.17g}, upper={:.17g}, part_triangle={}, environment_triangle={})",
        result.lower, result.upper, witness.partTriangle, witness.environmentTriangle);
}

/// (N, 3).
py::array_t<double> pointsOf(const std::vector<Witness>& witnesses, Vector3 Witness::*member) {
    py::array_t<double> column({static_cast<py::ssize_t>(witnesses.size()), py::ssize_t{3}});
    for (std::size_t i = 0; i < witnesses.size(); ++i) {
        for (int axis = 0; axis < 3; ++axis) column.mutable_at(i, axis) = (witnesses[i].*member)[axis];
    }
    return column;
}

/// The results of many poses, as arrays.
py::dict arraysOf(const std::vector<DistanceResult>& results) {
    py::dict arrays;
    std::vector<Witness> witnesses;
    for (const DistanceResult& result : results) witnesses.push_back(witnessOf(result));
    arrays["lower"] = columnOf<double>(results, &DistanceResult::lower);
    arrays["upper"] = columnOf<double>(results, &DistanceResult::upper);
    arrays["distance"] = columnOf<double>(results, &DistanceResult::distance);
    arrays["point_on_part"] = pointsOf(witnesses, &Witness::pointOnPart);
    arrays["point_on_environment"] = pointsOf(witnesses, &Witness::pointOnEnvironment);
    arrays["part_triangle"] = columnOf<std::int64_t>(witnesses, &Witness::partTriangle);
    arrays["environment_triangle"] = columnOf<std::int64_t>(witnesses, &Witness::environmentTriangle);
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
        .def_property_readonly(
            "point_on_part", [](const DistanceResult& result) { return witnessOf(result).pointOnPart; },
            R"((3,): the part's point of the closest pair, environment frame.)")
        .def_property_readonly(
            "point_on_environment",
            [](const DistanceResult& result) { return witnessOf(result).pointOnEnvironment; },
            R"((3,): the environment's point of the closest pair, environment frame.)")
        .def_property_readonly(
            "part_triangle", [](const DistanceResult& result) { return witnessOf(result).partTriangle; },
            R"(The row of the part's triangles that has the point; -1 beyond the cap.)")
        .def_property_readonly(
            "environment_triangle",
            [](const DistanceResult& result) { return witnessOf(result).environmentTriangle; },
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
        "near_pairs",
        [](const Model& part, const Model& environment, const Pose& pose, double band,
           OwnedWorkspace* workspace) { return nearPairs(part, environment, pose, band, chosen(workspace)); },
        py::arg("part"), py::arg("environment"), py::arg("pose"), py::arg("band"),
        py::arg("workspace") = py::none(), WithoutGil(),
        R"(The pairs of triangles whose distance is at most the band, the nearest first, as DistanceResults. Of more than 3,000 only the
nearest of each pair of leaves are kept, of more than 30,000 those of each leaf of the part. pose: (4, 4).)");
    module.def(
        "distance_gradient",
        [](const DistanceResult& pair, const Vector3& centre) -> py::object {
            const auto gradient = distanceGradient(pair, centre);
            if (!gradient) return py::none();
            return py::make_tuple(gradient->translation, gradient->rotation);
        },
        py::arg("pair"), py::arg("centre"),
        R"(How the distance of a pair changes as the part moves: (translation, rotation), two (3,), by which a small displacement and a
small rotation vector about the centre (3,) are multiplied; environment frame. None on contact and beyond the cap.)");
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
                throw ArgumentError(
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

/// Makes the exception class clearway.NAME.
PyObject* addError(py::module_& module, const char* name, const char* words, const py::tuple& bases) {
    const std::string path = std::string("clearway.") + name;
    PyObject* const made = PyErr_NewExceptionWithDoc(path.c_str(), words, bases.ptr(), nullptr);
    if (!made) throw py::error_already_set();
    module.attr(name) = py::handle(made);
    return made;  // never freed: errors may be raised as long as the process lives
}

/// C++'s types of errors as Python's. As for io.UnsupportedOperation, a file that cannot be used is wrong as a value and as a file.
void bindErrors(py::module_& module) {
    const auto of = [](auto*... bases) { return py::make_tuple(py::handle(bases)...); };
    PyObject* const base =
        addError(module, "Error", "What clearway raises because an argument, a file or OMPL is at fault.",
                 of(PyExc_Exception));
    static PyObject *argumentError, *fileError, *omplError;
    argumentError = addError(module, "ArgumentError",
                             "An argument, or a value in a problem or path file, is not what was expected.",
                             of(base, PyExc_ValueError));
    fileError = addError(module, "FileError",
                         "A file cannot be read or written, or is not what its format prescribes.",
                         of(base, PyExc_OSError, PyExc_ValueError));
    omplError =
        addError(module, "OmplError", "OMPL refuses what clearway asks of it.", of(base, PyExc_RuntimeError));
    py::register_exception_translator([](std::exception_ptr thrown) {
        try {
            if (thrown) std::rethrow_exception(thrown);
        } catch (const ArgumentError& error) {
            PyErr_SetString(argumentError, error.what());
        } catch (const FileError& error) {
            PyErr_SetString(fileError, error.what());
        } catch (const OmplError& error) {
            PyErr_SetString(omplError, error.what());
        }
    });
}

}  // namespace
}  // namespace clearway::python

PYBIND11_MODULE(_core, module) {
    module.attr("__version__") = CLEARWAY_VERSION;
    clearway::python::bindErrors(module);
    clearway::python::bindMeshesAndModels(module);
    clearway::python::bindQueries(module);
    clearway::python::bindProblems(module);
    clearway::python::bindScenes(module);
    clearway::python::bindStates(module);
    clearway::python::RunningWork::watchPython();
}
