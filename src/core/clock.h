// The clock that durations are measured with. It never goes back.
#pragma once

#include <chrono>

namespace clearway {

using Clock = std::chrono::steady_clock;

inline double secondsSince(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

}  // namespace clearway
