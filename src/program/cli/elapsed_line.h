// Shows on a terminal that work goes on, and for how long.
#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace clearway::cli {

/// While it lives, a line on stderr counts the seconds: "planning 12 s". Prints nothing unless stderr is a
/// terminal.
class ElapsedLine {
  public:
    explicit ElapsedLine(std::string what);
    ~ElapsedLine();  ///< wipes the line
    ElapsedLine(const ElapsedLine&) = delete;
    ElapsedLine& operator=(const ElapsedLine&) = delete;

  private:
    void run();

    std::string what_;
    std::mutex mutex_;
    std::condition_variable ended_;
    bool isEnded_ = false;
    std::thread thread_;  ///< last: begins when the rest is there
};

}  // namespace clearway::cli
