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

/// How often a test does something, or how often it must: `all` in its long form, `few` in its short one.
inline int inForm(int all, int few) {
    return isFullRun() ? all : few;
}

}  // namespace clearway::testing
