// What info says about one mesh.
#pragma once

#include <string>

#include "clearway/build_options.h"
#include "clearway/mesh.h"

namespace clearway {

/// Prints what was read and applied, the box, whether the surface is closed, what cleaning did and the tree
/// it builds. reading: how the file was read, in words.
void describeMesh(const Mesh& mesh, const std::string& reading, const BuildOptions& options);

}  // namespace clearway
