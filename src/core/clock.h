// The clocks that durations are measured with. They never go back.
#pragma once

#include <time.h>

#include <chrono>

namespace clearway {

using Clock = std::chrono::steady_clock;

inline double secondsSince(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// Processor time of the calling thread, in seconds: what a busy machine leaves to others does not count.
inline double threadSeconds() {
    timespec used{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
    return double(used.tv_sec) + 1e-9 * double(used.tv_nsec);
}

}  // namespace clearway
