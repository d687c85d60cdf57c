// The pieces of the module, one for each source beside core.cpp.
#pragma once

#include <pybind11/pybind11.h>

#include <string>

namespace clearway::python {

void bindMeshesAndModels(pybind11::module_& module);
void bindProblems(pybind11::module_& module);
void bindScenes(pybind11::module_& module);
void bindStates(pybind11::module_& module);

/// Accepts "best", and "fast" with a DeprecationWarning. Throws ArgumentError for others.
void requirePreset(const std::string& name);

}  // namespace clearway::python
