#include "core/parallel.h"

#include <unistd.h>

#include <atomic>

namespace clearway {

bool mayShareWork() {
    static std::atomic<pid_t> sharer{
        0};  // the process that shared work first; constant initialisation takes no lock
    const pid_t process = getpid();
    pid_t first = 0;
    return sharer.compare_exchange_strong(first, process) || first == process;
}

}  // namespace clearway
