// What info says about a problem besides its meshes.
#pragma once

#include "clearway/problem.h"

namespace clearway::cli {

/// environmentBox: bounds the part's position where the problem states no volume.
/// Throws std::invalid_argument when the bounds leave out start or goal.
void describeProblem(const Problem& problem, const Box& environmentBox);

}  // namespace clearway::cli
