// Looks after work that does not look at its end itself.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "core/clock.h"

namespace clearway {

/// While it lives, a thread of its own asks isDue() some fifty times a second, and calls tell() once, so many seconds after the
/// first true. tell() is given a function that returns true when the watch has ended meanwhile; the destructor waits for it.
class Watch {
  public:
    using IsEnded = std::function<bool()>;

    Watch(std::function<bool()> isDue, double seconds, std::function<void(const IsEnded&)> tell)
        : isDue_(std::move(isDue)), seconds_(seconds), tell_(std::move(tell)), thread_([this] { run(); }) {}
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;

    ~Watch() {
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            isEnded_ = true;
        }
        ended_.notify_all();
        thread_.join();
    }

  private:
    void run() {
        std::optional<Clock::time_point> due;
        while (!due || secondsSince(*due) < seconds_) {
            std::unique_lock<std::mutex> lock(mutex_);
            if (ended_.wait_for(lock, std::chrono::milliseconds(20), [&] { return isEnded_.load(); })) return;
            lock.unlock();
            if (!due && isDue_()) due = Clock::now();
        }
        tell_([this] { return isEnded_.load(); });
    }

    const std::function<bool()> isDue_;
    const double seconds_;
    const std::function<void(const IsEnded&)> tell_;
    std::mutex mutex_;
    std::condition_variable ended_;
    std::atomic<bool> isEnded_{false};
    std::thread thread_;  // last: it starts when the other members are ready
};

}  // namespace clearway
