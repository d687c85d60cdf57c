// Time limits in tests that do not depend on the machine's other work: processor time, unlike the clock,
// stands still while other processes hold the processors.
#pragma once

#include <algorithm>
#include <chrono>
#include <ctime>
#include <thread>

namespace clearway::testing {

/// The processor time that this process has used so far, in all its threads.
inline double processorSeconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// The processor seconds that `work` takes, all threads added up.
template <typename Work>
double processorSecondsOf(Work work) {
    const double begin = processorSeconds();
    work();
    return processorSeconds() - begin;
}

/// The processor seconds that `work` takes, divided by the number of processors: never more than a clock
/// shows.
template <typename Work>
double secondsOnAllProcessors(Work work) {
    return processorSecondsOf(work) / std::max(1u, std::thread::hardware_concurrency());
}

/// Returns attempt(seconds), which stops after that many seconds on the clock. An attempt that ran until then
/// but was given less than half of that processor time proves nothing, so it is repeated with twice the
/// seconds.
template <typename Attempt>
auto withProcessorTime(double seconds, Attempt attempt) {
    using Clock = std::chrono::steady_clock;
    for (double limit = seconds;; limit *= 2) {
        const Clock::time_point begin = Clock::now();
        const double usedBefore = processorSeconds();
        auto result = attempt(limit);
        const std::chrono::duration<double> elapsed = Clock::now() - begin;
        const bool hasEndedEarly = elapsed.count() < 0.5 * limit;
        if (hasEndedEarly || processorSeconds() - usedBefore >= 0.5 * seconds) return result;
    }
}

}  // namespace clearway::testing
