// A case that broke a promise, made as small as it still does, and written so that it can be repeated.
#pragma once

#include <iosfwd>

#include "torture/pair_check.h"

namespace clearway::testing {

/// Leaves out triangles, takes the pose away, and rounds coordinates, as long as checkCase still complains.
PosedMeshes smallest(const PosedMeshes& posed, std::uint64_t choices);

/// The numbers of a pose, hexadecimal.
void printPose(std::ostream& out, const Pose& pose);

/// Triangles and pose as C++ initialisers of hexadecimal numbers, with the complaints.
void printRepeat(std::ostream& out, const PosedMeshes& posed, std::uint64_t choices);

}  // namespace clearway::testing
