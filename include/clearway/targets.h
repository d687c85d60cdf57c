// The instruction sets a query can run on. Process-wide; the best one the machine has is the default.
#pragma once

#include <string>
#include <vector>

namespace clearway {

/// Instruction sets this build holds and this machine can run, best first: of "avx3", "avx2", "sse4", "neon",
/// "scalar".
std::vector<std::string> availableTargets();

/// Runs every later query of the process on the named set; "best" goes back to the default. Not to be called
/// while a query runs. Throws std::invalid_argument that lists the available sets.
void useTarget(const std::string& name);

/// The set queries run on now.
std::string currentTarget();

}  // namespace clearway
