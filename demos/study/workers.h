// Processes that do the study's jobs, each pinned to a processor of its own, so that timed jobs do not disturb each other.
#pragma once

#include <sys/types.h>

#include <atomic>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace clearway::study {

struct Job {
    std::string text;                              ///< one line
    std::function<void(const std::string&)> keep;  ///< takes a line of its results
    std::function<void(const std::string&)> tell;  ///< takes a line for the user
    std::function<bool()> isStopped;               ///< true: the job is to end soon
};

/// Does a job. Returns false when it was stopped. May throw.
using DoJob = std::function<bool(const Job& job)>;

class Workers {
  public:
    /// Starts the processes as copies of this one, which must not have threads. Each calls doJob for its jobs. They ignore SIGINT.
    /// count: 0 means one for each processor that this process may use; never are there more. Throws std::runtime_error.
    Workers(std::size_t count, const DoJob& doJob);
    /// Ends the processes.
    ~Workers();
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;

    std::size_t count() const { return workers_.size(); }

    /// Has the jobs done. The next job goes to the next process that is idle. Calls `take` for each line that a job keeps, as soon as
    /// it is there, and `ended` after each job. Returns false when isStopped was true, or a job was stopped; lines that were kept
    /// have then been taken. Throws std::runtime_error when a job threw, or a process died.
    bool share(const std::vector<std::string>& jobs, const std::function<void(const std::string&)>& take,
               const std::function<void(const std::string&)>& tell, const std::function<void()>& ended,
               const std::function<bool()>& isStopped);

  private:
    struct Worker {
        pid_t process = 0;
        int toIt = -1, fromIt = -1;
        std::string received;  ///< without the lines that were handled
        std::string job;       ///< empty: idle
    };
    [[noreturn]] void serve(std::size_t processor, int in, int out, const DoJob& doJob);
    void start(std::size_t processor, const DoJob& doJob);

    std::vector<Worker> workers_;
    std::atomic<bool>* isStopped_;  ///< in memory that all processes share
};

}  // namespace clearway::study
