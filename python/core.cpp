// The module clearway for Python, without OMPL: its queries, and what the other sources bind. python/clearway/_core.pyi has the types.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstdint>
#include <limits>
#include <sstream>
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

Workspace& workspaceOfThread() {
    thread_local Workspace workspace;
    return workspace;
}

/// Answers a query with the given workspace or, for None, with one of the calling thread.
template <class Query>
auto answer(OwnedWorkspace* workspace, const Query& query) {
    Workspace& chosen = workspace ? workspace->mine() : workspaceOfThread();
    const ReleasedGil released;
    return query(chosen);
}

DistanceOptions optionsOf(double relativeError, double absoluteError, double cap) {
    DistanceOptions options;
    options.relativeError = relativeError;
    options.absoluteError = absoluteError;
    options.cap = cap;
    return options;
}

std::string describe(const DistanceResult& result) {
    std::ostringstream text;
    text.precision(17);
    text << "DistanceResult(lower=" << result.lower << ", upper=" << result.upper
         << ", part_triangle=" << witnessOf(result).partTriangle
         << ", environment_triangle=" << witnessOf(result).environmentTriangle << ")";
    return text.str();
}

/// The results of many poses, as arrays.
py::dict arraysOf(const std::vector<DistanceResult>& results) {
    const auto count = static_cast<py::ssize_t>(results.size());
    const std::pair<const char*, double DistanceResult::*> lengths[] = {
        {"lower", &DistanceResult::lower},
        {"upper", &DistanceResult::upper},
        {"distance", &DistanceResult::distance}};
    const std::pair<const char*, Vector3 Witness::*> points[] = {
        {"point_on_part", &Witness::pointOnPart}, {"point_on_environment", &Witness::pointOnEnvironment}};
    const std::pair<const char*, std::int64_t Witness::*> ids[] = {
        {"part_triangle", &Witness::partTriangle}, {"environment_triangle", &Witness::environmentTriangle}};
    py::dict arrays;
    for (const auto& [name, member] : lengths) {
        py::array_t<double> column(count);
        for (py::ssize_t i = 0; i < count; ++i) column.mutable_at(i) = results[i].*member;
        arrays[name] = column;
    }
    for (const auto& [name, member] : points) {
        py::array_t<double> column({count, py::ssize_t{3}});
        for (py::ssize_t i = 0; i < count; ++i) {
            const Vector3 point = witnessOf(results[i]).*member;
            for (int axis = 0; axis < 3; ++axis) column.mutable_at(i, axis) = point[axis];
        }
        arrays[name] = column;
    }
    for (const auto& [name, member] : ids) {
        py::array_t<std::int64_t> column(count);
        for (py::ssize_t i = 0; i < count; ++i) column.mutable_at(i) = witnessOf(results[i]).*member;
        arrays[name] = column;
    }
    return arrays;
}

py::array_t<bool> flagsOf(const std::vector<std::uint8_t>& flags) {
    py::array_t<bool> column(static_cast<py::ssize_t>(flags.size()));
    for (std::size_t i = 0; i < flags.size(); ++i) column.mutable_at(i) = flags[i] != 0;
    return column;
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
            "point_on_part",
            [](const DistanceResult& result) { return arrayOf(witnessOf(result).pointOnPart); },
            R"((3,): the part's point of the closest pair, environment frame.)")
        .def_property_readonly(
            "point_on_environment",
            [](const DistanceResult& result) { return arrayOf(witnessOf(result).pointOnEnvironment); },
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
        [](const Model& part, const Model& environment, const py::object& pose, OwnedWorkspace* workspace,
           double relativeError, double absoluteError, double cap) {
            const Pose X = poseOf(pose);
            const DistanceOptions options = optionsOf(relativeError, absoluteError, cap);
            return answer(workspace, [&](Workspace& scratch) {
                return distance(part, environment, X, options, scratch);
            });
        },
        py::arg("part"), py::arg("environment"), py::arg("pose"), py::arg("workspace") = py::none(),
        py::kw_only(), py::arg("relative_error") = 0.0, py::arg("absolute_error") = 0.0,
        py::arg("cap") = kInfinity,
        R"(The distance of the part at the pose from the environment. pose: (4, 4), X_environment_part. The interval may be as
wide as the larger of absolute_error, relative_error * lower and rounding; distances above the cap do not matter.)");
    module.def(
        "collides",
        [](const Model& part, const Model& environment, const py::object& pose, OwnedWorkspace* workspace) {
            const Pose X = poseOf(pose);
            return answer(workspace,
                          [&](Workspace& scratch) { return collides(part, environment, X, scratch); });
        },
        py::arg("part"), py::arg("environment"), py::arg("pose"), py::arg("workspace") = py::none(),
        R"(Whether the part at the pose and the environment share a point, exactly. pose: (4, 4).)");
    module.def(
        "is_within",
        [](const Model& part, const Model& environment, const py::object& pose, double d,
           OwnedWorkspace* workspace) {
            const Pose X = poseOf(pose);
            return answer(workspace,
                          [&](Workspace& scratch) { return isWithin(part, environment, X, d, scratch); });
        },
        py::arg("part"), py::arg("environment"), py::arg("pose"), py::arg("d"),
        py::arg("workspace") = py::none(),
        R"(Whether the distance is <= d, exactly. pose: (4, 4). d: environment units, >= 0.)");
    module.def(
        "distance_batch",
        [](const Model& part, const Model& environment, const py::object& poses, double relativeError,
           double absoluteError, double cap) {
            const std::vector<Pose> X = posesOf(poses);
            const DistanceOptions options = optionsOf(relativeError, absoluteError, cap);
            std::vector<DistanceResult> results;
            {
                const ReleasedGil released;
                results = distanceBatch(part, environment, X, options);
            }
            return arraysOf(results);
        },
        py::arg("part"), py::arg("environment"), py::arg("poses"), py::kw_only(),
        py::arg("relative_error") = 0.0, py::arg("absolute_error") = 0.0, py::arg("cap") = kInfinity,
        R"(distance() for poses (N, 4, 4), on all cores. Returns a dict of arrays, named as DistanceResult's attributes: lengths
and ids (N,), points (N, 3). Order the poses as along a path.)");
    module.def(
        "is_within_batch",
        [](const Model& part, const Model& environment, const py::object& poses, double d) {
            const std::vector<Pose> X = posesOf(poses);
            std::vector<std::uint8_t> flags;
            {
                const ReleasedGil released;
                flags = isWithinBatch(part, environment, X, d);
            }
            return flagsOf(flags);
        },
        py::arg("part"), py::arg("environment"), py::arg("poses"), py::arg("d"),
        R"(is_within() for poses (N, 4, 4), on all cores; d = 0 asks for contact. Returns (N,) bools.)");
    module.def(
        "pose_from",
        [](const std::vector<double>& position, const std::vector<double>& quaternion) {
            if (position.size() != 3 || quaternion.size() != 4) {
                throw ArgumentError("position and quaternion have " + std::to_string(position.size()) +
                                    " and " + std::to_string(quaternion.size()) +
                                    " numbers, expected 3 and 4");
            }
            return arrayOf(
                toPose(Eigen::Quaterniond(quaternion[3], quaternion[0], quaternion[1], quaternion[2]),
                       Vector3(position[0], position[1], position[2])));
        },
        py::arg("position"), py::arg("quaternion"),
        R"(The (4, 4) pose of a position (x, y, z) and a quaternion (x, y, z, w), which is normalised first.)");
    module.def(
        "nearest_pose",
        [](const py::object& matrix) {
            const auto numbers = numbersOf(matrix, "matrix", 2);
            if (numbers.shape(0) != 4 || numbers.shape(1) != 4) {
                throw ArgumentError("matrix has shape " + shapeOf(numbers) + ", expected (4, 4)");
            }
            Pose pose;
            for (int row = 0; row < 3; ++row) {
                for (int column = 0; column < 3; ++column)
                    pose.rotation(row, column) = numbers.at(row, column);
                pose.translation[row] = numbers.at(row, 3);
            }
            return arrayOf(nearestPose(pose));
        },
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
    clearway::python::LockedStretch::watchPython();
}
