// How long the rest of even pieces of work takes, as words.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace clearway::study {

class TimeLeft {
  public:
    /// mostEach: seconds, told until the first piece is done.
    TimeLeft(std::size_t pieces, double mostEach);

    void step() { ++done_; }
    std::size_t done() const { return done_; }
    std::size_t all() const { return pieces_; }

    /// "about 12 min left", "at most 3 h 20 min left".
    std::string text() const;

  private:
    std::size_t pieces_;
    double mostEach_;
    std::size_t done_ = 0;
    std::chrono::steady_clock::time_point begin_;
};

/// "45 s", "12 min", "3 h 20 min".
std::string durationText(double seconds);

}  // namespace clearway::study
