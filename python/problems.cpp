// Problem files and path files for Python.
#include <fmt/format.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "clearway/errors.h"
#include "clearway/problem.h"
#include "python/arrays.h"
#include "python/bindings.h"
#include "python/paths.h"
#include "python/scenes.h"

namespace clearway::python {
namespace {

using FileName = std::filesystem::path;

Space spaceNamed(const std::string& name) {
    if (name == "SE3") return Space::kSe3;
    if (name == "SE2") return Space::kSe2;
    throw ArgumentError("space is '" + name + "', expected 'SE3' or 'SE2'");
}

const char* nameOf(Space space) {
    return space == Space::kSe3 ? "SE3" : "SE2";
}

void setBounds(Problem& problem, const py::object& bounds) {
    if (bounds.is_none()) return problem.volume.reset();
    const auto corners = numbersOf(bounds, "bounds", 2);
    if (corners.shape(0) != 2 || corners.shape(1) != 3) {
        throw ArgumentError("bounds has shape " + shapeOf(corners) + ", expected (2, 3)");
    }
    Box box;
    for (int axis = 0; axis < 3; ++axis) {
        box.min()[axis] = corners.at(0, axis);
        box.max()[axis] = corners.at(1, axis);
        if (!(box.min()[axis] <= box.max()[axis]) || !std::isfinite(box.sizes()[axis])) {
            throw ArgumentError(
                fmt::format("bounds[:, {}] is {} to {}, expected finite numbers, the least first", axis,
                            box.min()[axis], box.max()[axis]));
        }
    }
    problem.volume = box;
}

void setGoal(Problem& problem, const py::object& goal) {
    problem.goal = stateOf(poseOf(goal, "goal"), problem.space, "goal");
    problem.outside.reset();
}

Problem makeProblem(const py::object& start, const py::object& goal, const std::string& space,
                    const py::object& bounds, double margin, const FileName& robot,
                    const std::vector<FileName>& worlds) {
    Problem problem;
    problem.space = spaceNamed(space);
    problem.start = stateOf(poseOf(start, "start"), problem.space, "start");
    setGoal(problem, goal);
    setBounds(problem, bounds);
    problem.margin = requireMargin(margin);
    problem.meshes.robot = robot.string();
    for (const FileName& world : worlds) {
        if (problem.meshes.world.empty()) {
            problem.meshes.world = world.string();
        } else {
            problem.meshes.furtherWorlds.push_back(world.string());
        }
    }
    problem.meshes.asOmplApp = false;
    return problem;
}

/// The array, which Python may not change: a change would not reach the problem.
py::array_t<double> frozen(py::array_t<double> array) {
    array.attr("flags").attr("writeable") = false;
    return array;
}

py::object goalOf(const Problem& problem) {
    if (problem.outside) return py::none();
    return frozen(arrayOf(poseOf(problem.goal)));
}

py::object volumeOf(const Problem& problem) {
    if (!problem.volume) return py::none();
    return frozen(arrayOf(*problem.volume));
}

std::optional<std::string> outsideOf(const Problem& problem) {
    if (!problem.outside) return std::nullopt;
    return problem.outside->side ? nameOf(*problem.outside->side) : "any side";
}

std::vector<std::string> worldsOf(const Problem& problem) {
    return problem.meshes.world.empty() ? std::vector<std::string>() : worldFiles(problem);
}

std::vector<std::string> plannersOf(const Problem& problem) {
    std::vector<std::string> names;
    for (const PlannerChoice& choice : problem.planning.planners) names.push_back(choice.name);
    return names;
}

void bindPathFiles(py::module_& module) {
    module.def(
        "read_path",
        [](const FileName& file, const std::string& space) {
            return posesOf(readPath(file.string(), spaceNamed(space)));
        },
        py::arg("file"), py::kw_only(), py::arg("space") = "SE3",
        R"(Reads a path file, one state a line: x y z qx qy qz qw in SE3, x y yaw in SE2. Returns poses (N, 4, 4),
X_environment_part. Raises FileError when the file cannot be read, ArgumentError naming the line that is wrong.)");
    module.def(
        "write_path",
        [](const py::object& path, const FileName& file, const std::string& name) {
            const Space space = spaceNamed(name);
            writePath(statesOf(path, space), space, file.string());
        },
        py::arg("path"), py::arg("file"), py::kw_only(), py::arg("space") = "SE3",
        R"(Writes a path file, with 17 digits. path: poses (N, 4, 4) or states (N, 7), x y z qx qy qz qw. In SE2 they lie in the
plane: z is 0, and turns are about z. The file is written under a temporary name, then renamed.)");
    module.def(
        "poses_from_states", [](const py::object& states) { return posesOf(statesOf(states)); },
        py::arg("states"),
        R"(The poses (N, 4, 4) of states (N, 7): x y z, then a quaternion qx qy qz qw, which is normalised first.)");
    module.def(
        "states_from_poses", [](const py::object& poses) { return arrayOf(statesOf(poses)); },
        py::arg("poses"),
        R"(The states (N, 7), x y z qx qy qz qw, of poses (N, 4, 4). Quaternions have unit length.)");
}

}  // namespace

void bindProblems(py::module_& module) {
    py::class_<Problem>(
        module, "Problem",
        R"(A planning problem, as a problem file (.cfg) has it: start, goal, bounds, margin and mesh files. Lengths are in the
environment's unit. Poses are (4, 4), X_environment_part.)")
        .def(
            py::init(&makeProblem), py::arg("start"), py::arg("goal"), py::kw_only(),
            py::arg("space") = "SE3", py::arg("bounds") = py::none(), py::arg("margin") = 0.0,
            py::arg("robot") = "", py::arg("worlds") = std::vector<FileName>(),
            R"(A problem made in memory. robot, worlds: mesh files of the part and of the environment, read as they are stored;
without them the problem needs a Scene to plan in. Further rules, such as margins by name, need a problem file.)")
        .def_static(
            "load", [](const FileName& file) { return readProblem(file.string()); }, py::arg("file"),
            R"(Reads a problem file. Raises FileError when it cannot be read, ArgumentError naming the key that is wrong. The mesh files
are not read yet: Scene.load does that.)")
        .def(
            "save",
            [](const Problem& problem, const FileName& file) {
                requireMeshFiles(problem);
                writeProblem(problem, file.string());
            },
            py::arg("file"), R"(Writes a problem file that load reads back to equal values.)")
        .def_readonly("file", &Problem::file, R"(The problem file; empty when made in memory.)")
        .def_readonly("name", &Problem::name, R"(The problem's name, from its file.)")
        .def_property_readonly(
            "robot", [](const Problem& problem) { return problem.meshes.robot; },
            R"(The mesh file of the part, with its folder.)")
        .def_property_readonly("worlds", &worldsOf,
                               R"(The mesh files of the environment, with their folders.)")
        .def_property_readonly(
            "space", [](const Problem& problem) { return nameOf(problem.space); },
            R"("SE3", or "SE2" for motions in the plane of x and y.)")
        .def_property(
            "start", [](const Problem& problem) { return frozen(arrayOf(poseOf(problem.start))); },
            [](Problem& problem, const py::object& pose) {
                problem.start = stateOf(poseOf(pose, "start"), problem.space, "start");
            },
            R"((4, 4), X_environment_part at the start. The array is read-only; assign another one.)")
        .def_property(
            "goal", &goalOf, &setGoal,
            R"((4, 4), X_environment_part at the goal, read-only; None for a goal outside. Assigning a pose ends that.)")
        .def_property_readonly(
            "outside", &outsideOf,
            R"(For a goal outside of the environment's box the side, "+x" ... "-z", or "any side"; None for a goal pose.)")
        .def_property(
            "bounds", &volumeOf, &setBounds,
            R"((2, 3): the least and the greatest position of the part's origin, environment frame, read-only. None: the environment's
box grown to hold start and goal.)")
        .def_property(
            "margin", [](const Problem& problem) { return problem.margin; },
            [](Problem& problem, double margin) { problem.margin = requireMargin(margin); },
            R"(The distance to keep from obstacles that no rule of the file names; environment units, >= 0.)")
        .def_readonly("unit", &Problem::unit,
                      R"(The unit of all lengths, such as "mm", to be shown beside them; empty: not stated.)")
        .def_property_readonly(
            "objective", [](const Problem& problem) { return problem.planning.objective; },
            R"(The name of the problem's objective.)")
        .def_property_readonly("planners", &plannersOf, R"(The names of the planners in the file.)")
        .def_readonly("warnings", &Problem::warnings,
                      R"(One line for each key of the file that has no effect.)")
        .def("__copy__", [](const Problem& problem) { return problem; })
        .def("__deepcopy__", [](const Problem& problem, const py::dict& /*memo*/) { return problem; })
        .def("__repr__", [](const Problem& problem) {
            return fmt::format("Problem({}, {})", nameOf(problem.space),
                               problem.file.empty() ? "made in memory" : "'" + problem.file + "'");
        });
    bindPathFiles(module);
}

}  // namespace clearway::python
