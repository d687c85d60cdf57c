// The overlaps with which a part that touches or is pressed into its surroundings comes free.
#pragma once

#include "clearway/problem.h"
#include "program/options/shared_options.h"

namespace clearway::cli {

/// For a start in collision: prints the least overlap that frees it and the one to try first, as lines for the problem, the latter last. The
/// problem's own margins and overlaps do not count. Prints and returns nothing if the start is free, or not freed by a hundredth of the
/// part's size.
bool tellLift(Problem problem, ProblemScenes& scenes);

}  // namespace clearway::cli
