// Keeps the calling thread on one CPU while it lives. Where the system offers no such thing, does nothing.
#pragma once

#ifdef __linux__
#include <sched.h>

#include <stdexcept>
#include <string>
#endif

namespace clearway::testing {

class Pinned {
  public:
#ifdef __linux__
    /// cpu: -1 for any. Throws std::invalid_argument when the thread may not run there.
    explicit Pinned(int cpu) {
        sched_getaffinity(0, sizeof before_, &before_);
        if (cpu < 0) return;
        cpu_set_t one;
        CPU_ZERO(&one);
        if (cpu < CPU_SETSIZE) CPU_SET(cpu, &one);
        if (sched_setaffinity(0, sizeof one, &one) != 0) {
            throw std::invalid_argument("cpu is " + std::to_string(cpu) +
                                        ", expected one this process may use");
        }
    }
    ~Pinned() {
        sched_setaffinity(0, sizeof before_, &before_);
    }

  private:
    cpu_set_t before_;

  public:
#else
    explicit Pinned(int) {}
#endif
    Pinned(const Pinned&) = delete;
    Pinned& operator=(const Pinned&) = delete;
};

}  // namespace clearway::testing
