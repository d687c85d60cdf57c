// Checks of the arguments of queries. Each function throws std::invalid_argument that names the value and the range
// expected.
#pragma once

#include "clearway/model.h"

namespace clearway {

void requireNotNegative(double value, const char* name);

/// Both models must have nodes of one width.
void requireSameWidth(const Model& part, const Model& environment);

}  // namespace clearway
