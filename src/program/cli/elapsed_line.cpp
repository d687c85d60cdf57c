#include "program/cli/elapsed_line.h"

#include <unistd.h>

#include <chrono>
#include <iostream>

namespace clearway::cli {

ElapsedLine::ElapsedLine(std::string what) : what_(std::move(what)) {
    if (isatty(STDERR_FILENO)) thread_ = std::thread([this] { run(); });
}

ElapsedLine::~ElapsedLine() {
    if (!thread_.joinable()) return;
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        isEnded_ = true;
    }
    ended_.notify_one();
    thread_.join();
}

void ElapsedLine::run() {
    std::unique_lock<std::mutex> lock(mutex_);
    for (int seconds = 1; !ended_.wait_for(lock, std::chrono::seconds(1), [this] { return isEnded_; });
         ++seconds) {
        std::cerr << '\r' << what_ << ' ' << seconds << " s" << std::flush;
    }
    std::cerr << "\r\033[K" << std::flush;
}

}  // namespace clearway::cli
