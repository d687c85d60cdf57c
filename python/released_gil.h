// Work without Python's lock, so that other threads of Python run meanwhile; and what becomes of it when Python ends.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <thread>

namespace clearway::python {

namespace py = pybind11;

/// A stretch of C++ that comes back to Python's lock. When Python has ended, it unwinds each thread that asks for the lock,
/// which destructors of C++ do not stand: the process would abort. So Python's end waits for the stretches that have begun,
/// and a thread that Python does not wait for, a daemon, rests for good when it begins another one.
class LockedStretch {
  public:
    LockedStretch() {
        if (isEnding() && depth() == 0 && std::this_thread::get_id() != endingThread()) rest();
        ++depth();
        ++count();
    }
    ~LockedStretch() {
        --depth();
        --count();
    }
    LockedStretch(const LockedStretch&) = delete;
    LockedStretch& operator=(const LockedStretch&) = delete;

    /// Lets Python call the two functions below when it ends, and in forked processes.
    static void watchPython() {
        py::module_::import("atexit").attr("register")(py::cpp_function(&endAll));
        py::module_::import("os").attr("register_at_fork")(py::arg("after_in_child") =
                                                               py::cpp_function(&forgetOtherThreads));
    }

  private:
    static void endAll() {
        endingThread() = std::this_thread::get_id();
        isEnding() = true;
        const py::gil_scoped_release released;
        while (count() > 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    /// A forked process has this thread alone.
    static void forgetOtherThreads() { count() = depth(); }

    [[noreturn]] static void rest() {
        PyEval_SaveThread();
        for (;;) std::this_thread::sleep_for(std::chrono::hours(1));
    }

    static std::atomic<bool>& isEnding() {
        static std::atomic<bool> value{false};
        return value;
    }
    static std::thread::id& endingThread() {
        static std::thread::id value;
        return value;
    }
    static std::atomic<int>& count() {
        static std::atomic<int> value{0};
        return value;
    }
    static int& depth() {
        thread_local int value = 0;
        return value;
    }
};

/// While an object lives, its thread is without Python's lock.
class ReleasedGil {
    const LockedStretch stretch_;
    const py::gil_scoped_release released_;
};

}  // namespace clearway::python
