#include "bench/pinned.h"

#ifdef __linux__
#include <sched.h>

#include <stdexcept>
#include <string>
#endif

namespace clearway::testing {

#ifdef __linux__
namespace {

/// Remembers the CPUs that the thread may run on and restores them at the end.
class Affinity {
  public:
    Affinity() { sched_getaffinity(0, sizeof before_, &before_); }
    ~Affinity() { sched_setaffinity(0, sizeof before_, &before_); }
    Affinity(const Affinity&) = delete;
    Affinity& operator=(const Affinity&) = delete;

  private:
    cpu_set_t before_;
};

void pin(int cpu) {
    cpu_set_t one;
    CPU_ZERO(&one);
    if (cpu < CPU_SETSIZE) CPU_SET(static_cast<std::size_t>(cpu), &one);
    if (sched_setaffinity(0, sizeof one, &one) != 0) {
        throw std::invalid_argument("cpu is " + std::to_string(cpu) + ", expected one this process may use");
    }
}

}  // namespace

void runPinned(int cpu, const std::function<void()>& work) {
    const Affinity affinity;
    if (cpu >= 0) pin(cpu);
    work();
}
#else
void runPinned(int, const std::function<void()>& work) {
    work();
}
#endif

}  // namespace clearway::testing
