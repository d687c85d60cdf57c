// Work without Python's lock, so that other threads of Python run meanwhile; and what becomes of it when Python ends.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <thread>

namespace clearway::python {

namespace py = pybind11;

/// A stretch of C++ that comes back to Python's lock. When Python has ended, it unwinds each thread that asks for the lock,
/// which destructors of C++ do not stand: the process would abort. So Python's end waits for the stretches that have begun.
/// A thread that begins another one meanwhile is a daemon, which Python does not wait for: it lets Python end first.
class LockedStretch {
  public:
    LockedStretch() {
        if (isEnding() && depth() == 0 && std::this_thread::get_id() != endingThread()) letPythonEnd();
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

    /// Goes on if Python does not end for a second: what else it calls at its end may wait for this thread.
    static void letPythonEnd() {
        PyThreadState* const state = PyEval_SaveThread();
        std::this_thread::sleep_for(std::chrono::seconds(1));
        while (hasPythonEnded()) std::this_thread::sleep_for(std::chrono::hours(1));
        PyEval_RestoreThread(state);
    }
    static bool hasPythonEnded() {
#if PY_VERSION_HEX >= 0x030D0000
        return Py_IsFinalizing();
#else
        return _Py_IsFinalizing();
#endif
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
