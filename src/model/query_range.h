// Environments built for a range: which triangles such a build leaves out, and which queries the result can
// answer.
#pragma once

#include <cstddef>

#include "clearway/model.h"
#include "mesh/clean.h"

namespace clearway {

/// Throws ArgumentError unless the range's positions are a finite box that is not empty, and its two
/// lengths are finite and at least 0.
void requireRange(const QueryRange& range);

/// Removes the triangles that are surely farther from the positions than partRadius + cap, and the vertices
/// that no triangle uses then. The other triangles keep their order and ids. No query at a pose within the
/// range can tell the difference, including its rounding. If all triangles would go, the first one stays,
/// because a mesh needs one. mesh.report is left as it is. Returns the number of removed triangles.
std::size_t leaveOutUnreachable(CleanMesh& mesh, const QueryRange& range);

/// Throws ArgumentError, naming the value and what was expected, when the part was built with a
/// range, or the environment's range does not hold the part or the pose's translation.
void requireWithinRange(const Model& part, const Model& environment, const Pose& X_environmentPart);

/// Throws ArgumentError when d is larger than the cap of the environment's range.
void requireWithinCap(const Model& environment, double d);

/// The smaller one of `cap` and the cap of the environment's range.
double cappedByRange(const Model& environment, double cap);

}  // namespace clearway
