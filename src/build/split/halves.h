// Halves: as many triangles on the one side as on the other, whatever their shape. What is left when a split
// finds nothing.
#pragma once

#include <cstddef>

#include "build/triangle_run.h"

namespace clearway {

/// Rearranges the run at the median of the centroids along the longest side of their box, by the triangles'
/// positions where those coincide, and returns the size of the left half: never 0, never all, for at least
/// two triangles.
std::size_t splitInHalves(const CleanMesh& mesh, TriangleRun run);

}  // namespace clearway
