// The overlaps with which a part that touches or is pressed into its surroundings comes free.
#pragma once

#include <optional>

#include "clearway/problem.h"
#include "program/options/shared_options.h"

namespace clearway::cli {

/// Overlaps for a start in collision; environment units.
struct Lift {
    double least = 0;     ///< frees the start, but leaves hardly any room to move
    double tryFirst = 0;  ///< frees the way, in most cases
};

/// None if the start is not in collision, or is not freed by a hundredth of the part's size. The problem's own margins and overlaps do not
/// count. Throws as shrink() does.
std::optional<Lift> findLift(Problem problem, ProblemScenes& scenes);

/// Prints both as lines for the problem, the one to try first last.
void tell(const Lift& lift);

/// Finds and tells it; in place of what findLift throws, a row says why no overlap can be allowed.
std::optional<Lift> tellLiftIfAny(const Problem& problem, ProblemScenes& scenes);

}  // namespace clearway::cli
