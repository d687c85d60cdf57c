// The instruction set that queries run on. The choice applies to the whole process. The default is the set that the
// environment variable CLEARWAY_TARGET names, or the best set that the machine has if the variable is unset or empty.
#pragma once

#include <string>
#include <vector>

#pragma GCC visibility push(default)

namespace clearway {

/// The instruction sets that this build contains and this machine can run, best first. Possible names:
/// "avx3", "avx2", "sse4", "neon", "scalar".
std::vector<std::string> availableTargets();

/// Makes all later queries of the process run on the named set, whatever CLEARWAY_TARGET names; "best" is the first of
/// availableTargets(). Must not be called while a query runs. Throws ArgumentError, which lists the
/// available sets, if the name is not available.
void useTarget(const std::string& name);

/// The instruction set that queries run on now. The first query or call of this function reads CLEARWAY_TARGET, unless
/// useTarget was called before. If the variable holds neither "best" nor an available name, this function and all
/// queries throw ArgumentError, which lists the available sets.
std::string currentTarget();

}  // namespace clearway

#pragma GCC visibility pop
