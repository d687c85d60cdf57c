// Makes a case that broke a promise as small as possible, and prints it so that it can be repeated.
#pragma once

#include <iosfwd>

#include "torture/pair_check.h"

namespace clearway::testing {

/// Leaves out triangles, removes the pose and rounds coordinates, as long as checkCase still complains.
PosedMeshes smallest(const PosedMeshes& posed, std::uint64_t choices);

/// Prints the numbers of a pose in hexadecimal.
void printPose(std::ostream& out, const Pose& pose);

/// Prints triangles and pose as C++ initialisers of hexadecimal numbers, with the complaints.
void printRepeat(std::ostream& out, const PosedMeshes& posed, std::uint64_t choices);

}  // namespace clearway::testing
