// A check of the arguments of queries.
#pragma once

#include "clearway/model.h"

namespace clearway {

/// Throws ArgumentError unless both models have nodes of one width.
void requireSameWidth(const Model& part, const Model& environment);

}  // namespace clearway
