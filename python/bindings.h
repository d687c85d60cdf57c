// The pieces of the module, one for each source beside core.cpp.
#pragma once

#include <pybind11/pybind11.h>

namespace clearway::python {

void bindMeshesAndModels(pybind11::module_& module);
void bindProblems(pybind11::module_& module);
void bindScenes(pybind11::module_& module);
void bindStates(pybind11::module_& module);

}  // namespace clearway::python
