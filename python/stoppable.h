// Work in a thread of its own, which the thread that asked for it can stop. Python goes on meanwhile: the asking thread waits
// without Python's lock, lets Python handle signals and calls back into Python now and then.
#pragma once

#include <pybind11/pybind11.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

namespace clearway::python {

namespace py = pybind11;

/// How often a waiting thread lets Python handle signals.
constexpr std::chrono::milliseconds kSignalPeriod{20};

/// Thrown where work that was stopped ends without a result.
struct Stopped {};

/// OMPL's console and its random numbers belong to the process, so that only one thread plans at a time.
class OneAtATime {
  public:
    /// Waits for its turn. Throws Stopped.
    template <class IsStopped>
    explicit OneAtATime(const IsStopped& isStopped) {
        static std::timed_mutex all;
        turn_ = std::unique_lock<std::timed_mutex>(all, std::defer_lock);
        while (!turn_.try_lock_for(kSignalPeriod)) {
            if (isStopped()) throw Stopped();
        }
    }

  private:
    std::unique_lock<std::timed_mutex> turn_;
};

/// The threads that wait for work, so that Python's end can wait for them: where Python ends, it kills threads that come back
/// to it, and what they wait for would still use the libraries while these are taken down.
class Waiting {
  public:
    Waiting() {
        process() = getpid();
        ++count();
    }
    ~Waiting() { --count(); }
    Waiting(const Waiting&) = delete;
    Waiting& operator=(const Waiting&) = delete;

    /// Stops all work, of daemon threads then, and returns when no thread waits. Python calls this before its end.
    static void endAll() {
        isEnding() = true;
        if (process() != getpid()) return;  // a forked process has none of these threads
        const py::gil_scoped_release released;
        while (count() > 0) std::this_thread::sleep_for(kSignalPeriod);
    }
    static std::atomic<bool>& isEnding() {
        static std::atomic<bool> value{false};
        return value;
    }

  private:
    static std::atomic<int>& count() {
        static std::atomic<int> value{0};
        return value;
    }
    static std::atomic<pid_t>& process() {
        static std::atomic<pid_t> value{0};
        return value;
    }
};

/// A thread that does some work, asked to end and waited for when the object dies.
class Worker {
  public:
    template <class Work>
    explicit Worker(const Work& work)
        : thread_([this, work] {
              try {
                  const OneAtATime turn([this] { return isStopped(); });
                  work(*this);
              } catch (const Stopped&) {  // also while it waited for its turn
              } catch (...) {
                  failure_ = std::current_exception();
              }
              const std::lock_guard<std::mutex> lock(mutex_);
              isDone_ = true;
              done_.notify_all();
          }) {}
    ~Worker() {
        stop();
        thread_.join();
    }
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    void stop() { isStopped_ = true; }
    bool isStopped() const { return isStopped_ || Waiting::isEnding(); }
    std::exception_ptr failure() const { return failure_; }  ///< once it is done

    /// Waits a little, without Python's lock; true when the work is done.
    bool wait() {
        const py::gil_scoped_release released;
        std::unique_lock<std::mutex> lock(mutex_);
        return done_.wait_for(lock, kSignalPeriod, [this] { return isDone_; });
    }

  private:
    std::atomic<bool> isStopped_{false};
    std::mutex mutex_;
    std::condition_variable done_;
    bool isDone_ = false;
    std::exception_ptr failure_;
    std::thread thread_;  // the last member: the thread uses the others
};

/// Does work(worker) in a thread of its own. Meanwhile the calling thread handles signals and calls look(), with Python's lock;
/// look returns false to stop the work. Returns None, or the exception that a signal's handler or look() raised, which
/// stops the work as well. Throws what the work throws, but for Stopped, unless it was stopped by such an exception.
template <class Work, class Look>
py::object runStoppable(const Work& work, const Look& look) {
    const Waiting waiting;
    Worker worker(work);
    py::object raised = py::none();
    while (!worker.wait()) {
        try {
            if (PyErr_CheckSignals() != 0) throw py::error_already_set();
            if (!worker.isStopped() && !look()) worker.stop();
        } catch (py::error_already_set& error) {
            if (raised.is_none()) raised = error.value();  // a second Ctrl-C adds nothing to the first
            worker.stop();
        }
    }
    if (worker.failure() && raised.is_none()) std::rethrow_exception(worker.failure());
    return raised;
}

}  // namespace clearway::python
