#include "bench/series.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

#include "bench/pinned.h"
#include "core/clock.h"

namespace clearway::testing {
namespace {

constexpr std::size_t kBatchPoses = 2048;

double nanosecondsSince(Clock::time_point start) {
    return std::chrono::duration<double, std::nano>(Clock::now() - start).count();
}

/// Asks at the poses in order until the time is up or all were asked.
void leadIn(const Series& series, const std::vector<Pose>& poses, double seconds) {
    const auto start = Clock::now();
    if (series.askAll) {
        if (seconds > 0) series.askAll(poses);
        return;
    }
    for (const std::size_t i : series.order) {
        if (nanosecondsSince(start) >= 1e9 * seconds) return;
        series.ask(poses[i]);
    }
}

/// Repeats the poses until every core gets many blocks.
std::vector<Pose> repeated(const std::vector<Pose>& poses) {
    std::vector<Pose> many;
    while (many.size() < kBatchPoses) many.insert(many.end(), poses.begin(), poses.end());
    return many;
}

void passOfAll(Series& series, const std::vector<Pose>& poses) {
    const std::vector<Pose> many = repeated(poses);
    const auto start = Clock::now();
    series.answers = series.askAll(many);
    const double each = nanosecondsSince(start) / static_cast<double>(many.size());
    series.answers.resize(poses.size());
    series.nanoseconds.emplace_back(poses.size(), each);
}

void passOneByOne(Series& series, const std::vector<Pose>& poses) {
    std::vector<double>& times = series.nanoseconds.emplace_back(poses.size());
    for (const std::size_t i : series.order) {
        if (series.beforeQuery) series.beforeQuery();
        const auto start = Clock::now();
        series.answers[i] = series.ask(poses[i]);
        times[i] = nanosecondsSince(start);
    }
}

/// Returns the seconds of the pass without its lead-in.
double pass(Series& series, const std::vector<Pose>& poses, const Schedule& schedule) {
    double seconds = 0;
    series.answers.resize(poses.size());
    runPinned(series.askAll ? -1 : schedule.cpu, [&] {
        if (series.beforePass) series.beforePass();
        leadIn(series, poses, schedule.leadIn);
        if (series.beforePass) series.beforePass();
        const auto start = Clock::now();
        series.askAll ? passOfAll(series, poses) : passOneByOne(series, poses);
        seconds = 1e-9 * nanosecondsSince(start);
    });
    return seconds;
}

}  // namespace

double Series::total(std::size_t repetition) const {
    return std::accumulate(nanoseconds[repetition].begin(), nanoseconds[repetition].end(), 0.0);
}

std::vector<double> Series::medians() const {
    std::vector<double> ofPoses;
    for (std::size_t i = 0; i < answers.size(); ++i) {
        std::vector<double> times;
        for (const auto& repetition : nanoseconds) times.push_back(repetition[i]);
        ofPoses.push_back(median(times));
    }
    return ofPoses;
}

std::vector<std::size_t> inOrder(std::size_t count) {
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    return order;
}

void runAll(std::vector<Series>& all, const std::vector<Pose>& poses, const Schedule& schedule) {
    std::vector<int> repetitions;
    for (Series& series : all) {
        const double seconds = pass(series, poses, schedule);
        const double fitting = std::floor(schedule.peerBudget / std::max(seconds, 1e-9));
        const int most = series.isClearway
                             ? schedule.repetitions
                             : static_cast<int>(std::min<double>(schedule.repetitions, fitting));
        repetitions.push_back(std::max(1, most));
        series.nanoseconds.clear();
    }
    for (int i = 0; i < schedule.repetitions; ++i) {
        for (std::size_t k = 0; k < all.size(); ++k) {
            if (i < repetitions[k]) pass(all[k], poses, schedule);
        }
    }
}

std::vector<double> ratios(const Series& ours, const Series& theirs) {
    std::vector<double> values;
    for (std::size_t i = 0; i < std::min(ours.nanoseconds.size(), theirs.nanoseconds.size()); ++i) {
        values.push_back(theirs.total(i) / ours.total(i));
    }
    return values;
}

double clockNanoseconds() {
    std::vector<double> times;
    for (int i = 0; i < 1000; ++i) times.push_back(nanosecondsSince(Clock::now()));
    return median(times);
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

double least(const std::vector<double>& values) {
    return *std::min_element(values.begin(), values.end());
}

double largest(const std::vector<double>& values) {
    return *std::max_element(values.begin(), values.end());
}

double mean(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace clearway::testing
