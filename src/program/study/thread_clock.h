// The processor time of one thread, which other programs on the machine do not add to.
#pragma once

#include <ctime>

namespace clearway::study {

/// Seconds of processor time that the calling thread has used so far.
inline double threadSeconds() {
    timespec used = {};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
    return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
}

}  // namespace clearway::study
