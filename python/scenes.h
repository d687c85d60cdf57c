// The classes behind clearway.Problem and clearway.Scene, which both extensions see.
#pragma once

#include <fmt/format.h>
#include <pybind11/pybind11.h>

#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "clearway/errors.h"
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

/// The name of a file: text, bytes or a path. Raises TypeError for anything else, ValueError for a name with a 0 in it.
inline std::string fileName(const pybind11::object& given) {
    PyObject* bytes = nullptr;
    if (!PyUnicode_FSConverter(given.ptr(), &bytes)) throw pybind11::error_already_set();
    return pybind11::reinterpret_steal<pybind11::bytes>(bytes);
}

/// A problem that is given as such or as a file's name.
inline Problem problemOf(const pybind11::object& given) {
    if (pybind11::isinstance<Problem>(given)) return given.cast<Problem>();
    return readProblem(fileName(given));
}

/// The margin. Throws ArgumentError when it is none; the problem's own words would blame its file.
inline double requireMargin(double margin) {
    if (margin >= 0 && std::isfinite(margin)) return margin;
    throw ArgumentError(fmt::format("margin is {}, expected a finite number >= 0", margin));
}

/// Throws ArgumentError when the problem has no mesh files.
inline void requireMeshFiles(const Problem& problem) {
    if (!problem.meshes.robot.empty() && !problem.meshes.world.empty()) return;
    throw ArgumentError("the problem names no mesh files, expected robot and worlds, or a scene");
}

}  // namespace clearway::python
