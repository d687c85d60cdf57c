// Tells tests whether their long forms are wanted.
#pragma once

#include <cstdlib>
#include <string>

namespace clearway::testing {

/// True with CLEARWAY_FULL=1 in the process's environment.
inline bool isFullRun() {
    const char* full = std::getenv("CLEARWAY_FULL");
    return full != nullptr && std::string(full) == "1";
}

}  // namespace clearway::testing
