// How much more or less one strategy takes than another, told apart from luck: ratios of pairs, and how sure
// their median is. Source: Efron, Bootstrap Methods, 1979; clusters are drawn whole, for what belongs to one
// run is not independent, and count alike, for how many pairs a run has says nothing of its worth.
#pragma once

#include <cstddef>
#include <vector>

namespace clearway::study {

struct PairedRatio {
    double median = 0;         ///< of the clusters' medians
    double low = 0, high = 0;  ///< the interval's ends: of 95 in 100 resamples the median is within
    std::size_t pairs = 0;
    std::size_t clusters = 0;
};

/// clusters: of each run the ratios of its pairs; empty ones do not count. The same numbers give the same
/// answer. Without any pair all is 0.
PairedRatio pairedRatio(const std::vector<std::vector<double>>& clusters);

/// Of at least one value; the mean of the two in the middle of an even number.
double median(std::vector<double> values);

}  // namespace clearway::study
