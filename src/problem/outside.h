// Contradictions of a goal outside.
#pragma once

#include "clearway/problem.h"

namespace clearway {

/// Throws ArgumentError, naming the problem's file, when the goal is outside but has contacts, which lie around a
/// pose.
void requireNoGoalContact(const Problem& problem);

}  // namespace clearway
