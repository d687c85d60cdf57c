// The one way in which building shares its work among threads.
#pragma once

#include <tbb/parallel_invoke.h>

#ifdef __SANITIZE_THREAD__
#include <sanitizer/tsan_interface.h>
#endif

namespace clearway {

/// Calls both functions, at the same time where TBB has a thread for it, and returns when both have returned.
/// It throws what one of them threw.
template <class First, class Second>
void invokeBoth(const First& first, const Second& second) {
#ifdef __SANITIZE_THREAD__
    // ThreadSanitizer cannot see how TBB, which is built without it, synchronises. Without these calls it
    // takes what the functions read for races, so many that a test of building took seven times as long.
    char begun, done;
    const auto ordered = [&begun, &done](const auto& function) {
        __tsan_acquire(&begun);
        function();
        __tsan_release(&done);
    };
    __tsan_release(&begun);
    tbb::parallel_invoke([&] { ordered(first); }, [&] { ordered(second); });
    __tsan_acquire(&done);
#else
    tbb::parallel_invoke(first, second);
#endif
}

}  // namespace clearway
