// How a build is cut into tasks.
#pragma once

#include <cstdint>

namespace clearway {

/// A node of more triangles has its two children built by two tasks. The cut depends on the tree alone, so
/// that the same tasks are done whatever the number of threads.
constexpr std::uint32_t kTaskTriangles = 4096;

}  // namespace clearway
