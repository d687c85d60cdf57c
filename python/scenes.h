// The classes behind clearway.Problem and clearway.Scene, which both extensions see.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "clearway/problem.h"
#include "clearway/scene_clearance.h"

namespace clearway::python {

/// clearway.Scene.
struct PyScene {
    explicit PyScene(Scene scene, std::vector<std::string> theNotes = {})
        : clearance(std::move(scene)), notes(std::move(theNotes)) {}

    const SceneClearance clearance;
    const std::vector<std::string> notes;  ///< from loading; see LoadedScene
};

/// A problem that is given as such or as a file's name.
inline Problem problemOf(const pybind11::object& given) {
    namespace py = pybind11;
    if (py::isinstance<Problem>(given)) return given.cast<Problem>();
    return readProblem(py::module_::import("os").attr("fspath")(given).cast<std::string>());
}

/// Throws std::invalid_argument when the problem has no mesh files.
inline void requireMeshFiles(const Problem& problem) {
    if (!problem.robot.empty() && !problem.world.empty()) return;
    throw std::invalid_argument("the problem names no mesh files, expected robot and worlds, or a scene");
}

}  // namespace clearway::python
