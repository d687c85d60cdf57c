// Whether an environment that lacks its unreachable triangles can answer a query.
#pragma once

#include "clearway/model.h"

namespace clearway {

/// Throws std::invalid_argument, naming the value and what was expected, when the part has a reach, or the
/// environment has one that does not hold the part or the pose's translation.
void requireWithinReach(const Model& part, const Model& environment, const Pose& X_environmentPart);

/// Throws likewise when d is larger than the cap of the environment's reach.
void requireWithinCap(const Model& environment, double d);

/// The lower of the two caps.
double cappedByReach(const Model& environment, double cap);

}  // namespace clearway
