// Keeps work on one CPU.
#pragma once

#include <functional>

namespace clearway::testing {

/// Runs the work with the calling thread kept on this CPU, then releases the thread. With -1, or on a system
/// that cannot pin threads, the work runs on any CPU. Throws std::invalid_argument if the thread may not run
/// on this CPU.
void runPinned(int cpu, const std::function<void()>& work);

}  // namespace clearway::testing
