// Work without Python's lock, so that other threads of Python run meanwhile; and what becomes of it when Python ends.
#pragma once

#include <pthread.h>
#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <optional>
#include <thread>

namespace clearway::python {

namespace py = pybind11;

/// Whether Python has ended. The process then ends too, and threads that Python does not wait for stop where they are.
inline std::atomic<bool> hasPythonEnded{false};

/// Counts what runs without Python's lock. Python's end waits for it, because it uses libraries that the process takes down next.
class RunningWork {
  public:
    RunningWork() { ++count_; }
    ~RunningWork() { --count_; }
    RunningWork(const RunningWork&) = delete;
    RunningWork& operator=(const RunningWork&) = delete;

    /// Each extension has its own count and calls this once.
    static void watchPython() {
        Py_AtExit([] {
            hasPythonEnded = true;
            while (count_ > 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        });
        pthread_atfork(nullptr, nullptr,
                       [] { count_ = 0; });  // a forked process has one thread, which runs Python
    }

  private:
    static inline std::atomic<int> count_{0};
};

/// Calls a function of Python's C interface that may wait for Python's lock. Where Python has ended, such a function unwinds its
/// thread, which destructors of C++ do not stand: the process would abort. The thread waits for the end of the process instead.
template <class Call>
auto callUnlessEnded(const Call& call) {
    try {
        return call();
    } catch (...) {  // C throws nothing else
        for (;;) std::this_thread::sleep_for(std::chrono::hours(1));
    }
}

/// While an object lives, its thread is without Python's lock. As pybind11's gil_scoped_release, but for threads that outlive Python.
class ReleasedGil {
  public:
    ReleasedGil() = default;
    ~ReleasedGil() {
        work_.reset();
        callUnlessEnded([this] { PyEval_RestoreThread(state_); });
    }
    ReleasedGil(const ReleasedGil&) = delete;
    ReleasedGil& operator=(const ReleasedGil&) = delete;

  private:
    std::optional<RunningWork> work_{std::in_place};
    PyThreadState* const state_ = PyEval_SaveThread();
};

/// For functions that are called without Python's lock.
using WithoutGil = py::call_guard<ReleasedGil>;

/// Returns the work's result.
template <class Work>
auto withoutGil(const Work& work) {
    const ReleasedGil released;
    return work();
}

}  // namespace clearway::python
