#include "core/parallel.h"

#include <pthread.h>

#include <atomic>

namespace clearway {
namespace {

enum class Sharing { kNotYet, kShared, kLost };

// Initialised when compiled and changed without a lock, so that a fork can fall anywhere.
std::atomic<Sharing> sharing{Sharing::kNotYet};

/// Called in each forked process, which has one thread.
void loseThreads() {
    if (sharing == Sharing::kShared) sharing = Sharing::kLost;
}

[[maybe_unused]] const int registered = pthread_atfork(nullptr, nullptr, &loseThreads);

}  // namespace

bool mayShareWork() {
    Sharing before = Sharing::kNotYet;
    return sharing.compare_exchange_strong(before, Sharing::kShared) || before == Sharing::kShared;
}

}  // namespace clearway
