// Tells before the work whether --swept-tolerance is too fine for a path.
#pragma once

#include <string>
#include <vector>

#include "program/cli/path_outputs.h"

namespace clearway::cli {

/// The tolerance of --swept: the stated one, or 1 % of the part's diagonal.
double sweptTolerance(const PathOutputs& outputs, const Model& part);

/// How far places of the part may be off a path's motions: by small turns, which OMPL may leave out, and by the floats of
/// the file. radius: the part's about its origin.
double sweptPlaceError(const std::vector<PartState>& path, double radius);

/// Why the room along the path cannot be told as finely as the tolerance asks: the part's places have an error of their
/// own. Empty where it can, or without --swept. A path of the start alone gives what holds for every path from there.
std::string whySweptIsTooFine(const PathOutputs& outputs, const Scene& scene,
                              const std::vector<PartState>& path);

}  // namespace clearway::cli
