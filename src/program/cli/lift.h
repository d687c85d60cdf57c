// The overlaps with which a part that touches or is pressed into its surroundings comes free.
#pragma once

#include <optional>

#include "clearway/problem.h"
#include "program/cli/overlaps.h"
#include "program/options/shared_options.h"

namespace clearway::cli {

/// Overlaps for a start in collision; environment units.
struct Lift {
    double least = 0;     ///< frees the start, but leaves hardly any room to move
    double tryFirst = 0;  ///< frees the way, in most cases
};

/// overlaps: those at the start. None if no surfaces touch there. The problem's own margins and overlaps do not count. Unless it
/// `isAsked` for, it ends after some seconds and tries no large overlaps. Throws std::invalid_argument when no overlap frees the start, and as
/// shrink() does.
std::optional<Lift> findLift(const Problem& problem, ProblemScenes& scenes,
                             const std::vector<FoundOverlap>& overlaps, bool isAsked);

/// Prints both as lines for the problem, the one to try first last.
void tell(const Lift& lift);

/// Finds and tells it, where nobody asked; in place of what findLift throws, a row says why none is known.
std::optional<Lift> tellLiftIfAny(const Problem& problem, ProblemScenes& scenes);

}  // namespace clearway::cli
