// Finds the triangles of an environment that no pose within a reach can bring within its cap.
#pragma once

#include <cstddef>

#include "clearway/reach.h"
#include "mesh/clean.h"

namespace clearway {

/// Throws std::invalid_argument unless the positions are a finite box that is not empty, and the two lengths
/// finite and at least 0.
void requireReach(const Reach& reach);

/// Removes the triangles that are surely farther from the positions than partRadius + cap, with the vertices
/// nobody uses then; the others keep their order and ids. Removes none that any query about a pose within the
/// reach could tell of, its rounding included. When it would be all, the first one stays: a mesh has a
/// triangle. mesh.report stays. Returns how many went.
std::size_t leaveOutUnreachable(CleanMesh& mesh, const Reach& reach);

}  // namespace clearway
