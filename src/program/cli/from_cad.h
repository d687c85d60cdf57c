// Meshes of STEP and IGES files, which the program clearway-cad makes.
#pragma once

#include <string>
#include <vector>

#include "program/options/print.h"

namespace clearway::cli {

/// Replaces each STEP or IGES file by a 3MF file of its name beside `out`, and returns a row about it. An existing file of that name is
/// renamed, as setAside does. Throws std::runtime_error when clearway-cad is neither beside this program nor on the PATH, with what it says
/// when it fails, and when two files would become one.
Rows makeMeshesOfCad(std::vector<std::string*> files, const std::string& out);

}  // namespace clearway::cli
