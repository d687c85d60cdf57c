// Watches a planner while it plans, from a thread of its own: memory, and what the planner tells of its
// progress.
#pragma once

#include <ompl/base/Planner.h>

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

#include "program/study/benchmark.h"

namespace clearway::study {

class RunWatch {
  public:
    /// bytes: the process may have. period: seconds between two looks.
    RunWatch(const ompl::base::Planner& planner, unsigned long long bytes, double period);
    ~RunWatch();
    RunWatch(const RunWatch&) = delete;
    RunWatch& operator=(const RunWatch&) = delete;

    bool isOutOfMemory() const { return isOutOfMemory_.load(std::memory_order_relaxed); }

    /// Ends the watch. returns the planner's progress, one entry a look; none from planners that tell none.
    std::vector<Properties> finish();

  private:
    void run(unsigned long long bytes, double period);

    ompl::base::Planner::PlannerProgressProperties properties_;
    std::vector<Properties> progress_;
    std::atomic<bool> isOutOfMemory_{false};
    std::mutex mutex_;
    std::condition_variable ended_;
    bool isEnded_ = false;
    std::thread thread_;  ///< last: begins when the rest is there
};

}  // namespace clearway::study
