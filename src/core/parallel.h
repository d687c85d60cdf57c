// The ways in which the library shares its work among threads.
#pragma once

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstddef>

#ifdef __SANITIZE_THREAD__
#include <sanitizer/tsan_interface.h>
#endif

namespace clearway {

/// Tells whether this process may use TBB, and remembers that it does. False in a process forked after that: what TBB's locks
/// guarded when the process was forked stays locked there for ever.
#pragma GCC visibility push(default)  // clearway::planning calls it
bool mayShareWork();
#pragma GCC visibility pop

/// Calls work(i) for every i below count, in parallel, and returns when all have returned. It throws what one of them threw.
template <class Work>
void forEachInParallel(std::size_t count, const Work& work) {
    if (mayShareWork()) {
        tbb::parallel_for(std::size_t(0), count, work);
    } else {
        for (std::size_t i = 0; i < count; ++i) work(i);
    }
}

/// Calls work(first, last) for runs of `count` items, of at most `atATime` items each, in parallel.
template <class Work>
void forEachRun(std::size_t count, std::size_t atATime, const Work& work) {
    forEachInParallel((count + atATime - 1) / atATime,
                      [&](std::size_t run) { work(run * atATime, std::min(count, (run + 1) * atATime)); });
}

/// Calls both functions, at the same time where TBB has a thread for it, and returns when both have returned.
/// It throws what one of them threw.
template <class First, class Second>
void invokeBoth(const First& first, const Second& second) {
    if (!mayShareWork()) {
        first();
        second();
        return;
    }
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

/// Runs `work` on at most `threads` threads (0: the caller's arena) and returns its result.
template <class Work>
auto onThreads(int threads, const Work& work) {
    if (threads == 0 || !mayShareWork()) return work();
    tbb::task_arena arena(threads);
    return arena.execute(work);
}

}  // namespace clearway
