// The instruction set that queries run on. The choice holds for the whole process; the default is the best
// set that the machine has.
#pragma once

#include <string>
#include <vector>

#pragma GCC visibility push(default)

namespace clearway {

/// The instruction sets that this build contains and this machine can run, best first. Possible names:
/// "avx3", "avx2", "sse4", "neon", "scalar".
std::vector<std::string> availableTargets();

/// Makes all later queries of the process run on the named set; "best" returns to the default. Must not be
/// called while a query runs. Throws std::invalid_argument, which lists the available sets, if the name is
/// not available.
void useTarget(const std::string& name);

/// The instruction set that queries run on now.
std::string currentTarget();

}  // namespace clearway

#pragma GCC visibility pop
