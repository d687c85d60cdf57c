// Work in a thread of its own, which the thread that asked for it can stop. Python goes on meanwhile: the asking thread waits
// without Python's lock, lets Python handle signals and calls back into Python now and then.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <exception>
#include <future>
#include <mutex>

#include "python/released_gil.h"

namespace clearway::python {

/// How often a waiting thread lets Python handle signals.
constexpr std::chrono::milliseconds kSignalPeriod{20};

/// Thrown where work that was stopped ends without a result.
struct Stopped {};

/// OMPL's console and its random numbers belong to the process, so that only one thread plans at a time.
inline std::timed_mutex planningTurn;

/// Does work(isStopped) in a thread of its own. Meanwhile the calling thread handles signals and calls look(), with Python's lock;
/// look returns false to stop the work. Returns None, or the exception that a signal's handler or look() raised, which
/// stops the work as well. Throws what the work throws, but for Stopped, unless it was stopped by such an exception.
template <class Work, class Look>
py::object runStoppable(const Work& work, const Look& look) {
    std::atomic<bool> isAskedToStop{false};
    auto worker = std::async(std::launch::async, [&] {
        const RunningWork running;
        const auto isStopped = [&] { return isAskedToStop || hasPythonEnded; };
        std::unique_lock<std::timed_mutex> turn(planningTurn, std::defer_lock);
        while (!turn.try_lock_for(kSignalPeriod)) {
            if (isStopped()) return;
        }
        try {
            work(isStopped);
        } catch (const Stopped&) {
        }
    });
    const auto isDone = [&] { return worker.wait_for(kSignalPeriod) == std::future_status::ready; };
    py::object raised = py::none();
    while (!withoutGil(isDone)) {
        try {
            if (PyErr_CheckSignals() != 0) throw py::error_already_set();
            if (!isAskedToStop && !look()) isAskedToStop = true;
        } catch (py::error_already_set& error) {
            if (raised.is_none()) raised = error.value();  // a second Ctrl-C adds nothing to the first
            isAskedToStop = true;
        }
    }
    if (raised.is_none()) worker.get();
    return raised;
}

}  // namespace clearway::python
