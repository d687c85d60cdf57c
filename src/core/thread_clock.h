// The processor's time of one thread: what other programs on the machine take does not count.
#pragma once

#include <ctime>

namespace clearway {

/// Seconds that the calling thread has had so far.
inline double threadSeconds() {
    timespec had = {};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &had);
    return static_cast<double>(had.tv_sec) + 1e-9 * static_cast<double>(had.tv_nsec);
}

}  // namespace clearway
