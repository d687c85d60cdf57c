// Meshes of STEP and IGES files, which the program clearway-cad makes where it is installed.
#pragma once

#include <string>
#include <vector>

#include "program/options/print.h"

namespace clearway::cli {

/// Replaces each STEP or IGES file by a 3MF file of its name beside `out`, and returns a row about it. An existing file of that name is
/// renamed, as setAside does. Without clearway-cad, beside this program or on the PATH, nothing is done: loadMesh refuses such files, and
/// names the command. Throws std::runtime_error with what clearway-cad says when it fails, and when two files would become one.
Rows makeMeshesOfCad(std::vector<std::string*> files, const std::string& out);

}  // namespace clearway::cli
