#include "study/paired_ratio.h"

#include <algorithm>
#include <cassert>
#include <random>

namespace clearway {
namespace {

constexpr std::size_t kResamples = 2000;
constexpr double kOutside = 0.025;  ///< of the resamples, at each end
constexpr std::uint64_t kSeed = 20131;

using Clusters = std::vector<std::vector<double>>;

double medianOfAll(const Clusters& clusters, const std::vector<std::size_t>& drawn) {
    std::vector<double> values;
    for (const std::size_t i : drawn) values.insert(values.end(), clusters[i].begin(), clusters[i].end());
    return median(std::move(values));
}

}  // namespace

double median(std::vector<double> values) {
    assert(!values.empty());
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 == 1) return *middle;
    return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

PairedRatio pairedRatio(const Clusters& all) {
    Clusters clusters;
    PairedRatio result;
    for (const auto& cluster : all) {
        if (cluster.empty()) continue;
        clusters.push_back(cluster);
        result.pairs += cluster.size();
    }
    result.clusters = clusters.size();
    if (clusters.empty()) return result;
    std::vector<std::size_t> drawn(clusters.size());
    for (std::size_t i = 0; i < drawn.size(); ++i) drawn[i] = i;
    result.median = medianOfAll(clusters, drawn);

    std::mt19937_64 random(kSeed);  // used as it is: the standard's distributions differ between libraries
    std::vector<double> medians;
    for (std::size_t i = 0; i < kResamples; ++i) {
        for (std::size_t& cluster : drawn) cluster = random() % clusters.size();
        medians.push_back(medianOfAll(clusters, drawn));
    }
    std::sort(medians.begin(), medians.end());
    const auto outside = static_cast<std::size_t>(kOutside * kResamples);
    result.low = medians[outside];
    result.high = medians[kResamples - 1 - outside];
    return result;
}

}  // namespace clearway
