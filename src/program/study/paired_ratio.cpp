#include "program/study/paired_ratio.h"

#include <algorithm>
#include <cassert>
#include <random>

namespace clearway::study {
namespace {

constexpr std::size_t kResamples = 2000;
constexpr double kOutside = 0.025;  ///< of the resamples, at each end
constexpr std::uint64_t kSeed = 20131;

}  // namespace

double median(std::vector<double> values) {
    assert(!values.empty());
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 == 1) return *middle;
    return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

PairedRatio pairedRatio(const std::vector<std::vector<double>>& clusters) {
    PairedRatio result;
    std::vector<double> ofClusters;
    for (const auto& cluster : clusters) {
        if (cluster.empty()) continue;
        ofClusters.push_back(median(cluster));
        result.pairs += cluster.size();
    }
    result.clusters = ofClusters.size();
    if (ofClusters.empty()) return result;
    result.median = median(ofClusters);

    std::mt19937_64 random(kSeed);  // used as it is: the standard's distributions differ between libraries
    std::vector<double> medians, drawn(ofClusters.size());
    for (std::size_t i = 0; i < kResamples; ++i) {
        for (double& cluster : drawn) cluster = ofClusters[random() % ofClusters.size()];
        medians.push_back(median(drawn));
    }
    std::sort(medians.begin(), medians.end());
    const auto outside = static_cast<std::size_t>(kOutside * kResamples);
    result.low = medians[outside];
    result.high = medians[kResamples - 1 - outside];
    return result;
}

}  // namespace clearway::study
