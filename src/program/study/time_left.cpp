#include "program/study/time_left.h"

#include <cmath>

namespace clearway::study {

TimeLeft::TimeLeft(std::size_t pieces, double mostEach)
    : pieces_(pieces), mostEach_(mostEach), begin_(std::chrono::steady_clock::now()) {}

std::string TimeLeft::text() const {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin_;
    const double each = done_ > 0 ? elapsed.count() / static_cast<double>(done_) : mostEach_;
    return (done_ > 0 ? "about " : "at most ") + durationText(each * static_cast<double>(pieces_ - done_)) +
           " left";
}

std::string durationText(double seconds) {
    const auto whole = static_cast<long long>(std::ceil(seconds));
    if (whole < 120) return std::to_string(whole) + " s";
    const long long minutes = (whole + 59) / 60;
    if (minutes < 120) return std::to_string(minutes) + " min";
    return std::to_string(minutes / 60) + " h " + std::to_string(minutes % 60) + " min";
}

}  // namespace clearway::study
