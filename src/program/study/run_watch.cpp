#include "program/study/run_watch.h"

#include <ompl/tools/benchmark/MachineSpecs.h>

#include <chrono>

#include "core/number.h"

namespace clearway::study {

RunWatch::RunWatch(const ompl::base::Planner& planner, unsigned long long bytes, double period)
    : properties_(planner.getPlannerProgressProperties()),
      thread_([this, bytes, period] { run(bytes, period); }) {}

RunWatch::~RunWatch() {
    finish();
}

std::vector<Properties> RunWatch::finish() {
    if (!thread_.joinable()) return {};
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        isEnded_ = true;
    }
    ended_.notify_one();
    thread_.join();
    return std::move(progress_);
}

void RunWatch::run(unsigned long long bytes, double period) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point begin = Clock::now();
    std::unique_lock<std::mutex> lock(mutex_);
    while (!ended_.wait_for(lock, std::chrono::duration<double>(period), [this] { return isEnded_; })) {
        if (ompl::machine::getProcessMemoryUsage() > bytes) isOutOfMemory_ = true;
        if (properties_.empty()) continue;
        Properties now = {
            {"time REAL", shortNumber(std::chrono::duration<double>(Clock::now() - begin).count())}};
        for (const auto& [name, value] : properties_) now[name] = value();
        progress_.push_back(now);
    }
}

}  // namespace clearway::study
