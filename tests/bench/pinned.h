// Work that stays on one CPU.
#pragma once

#include <functional>

namespace clearway::testing {

/// Runs the work with the calling thread kept on this CPU, and lets it go again; -1, and systems that offer
/// no such thing: on any. Throws std::invalid_argument when the thread may not run there.
void runPinned(int cpu, const std::function<void()>& work);

}  // namespace clearway::testing
