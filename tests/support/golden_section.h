// Golden-section search, for a value that falls and then rises.
#pragma once

#include <algorithm>

namespace clearway::testing {

/// Returns the least value that it finds within `step` of the middle, between 0 and `until`.
template <class Function>
double searchLeast(const Function& valueAt, double middle, double step, double until) {
    constexpr double kGolden = 0.6180339887498949;
    double low = std::max(0.0, middle - step), high = std::min(until, middle + step);
    double left = high - kGolden * (high - low), right = low + kGolden * (high - low);
    double atLeft = valueAt(left), atRight = valueAt(right), least = valueAt(middle);
    for (int steps = 0; steps < 30; ++steps) {
        least = std::min({least, atLeft, atRight});
        if (atLeft < atRight) {
            high = right, right = left, atRight = atLeft;
            left = high - kGolden * (high - low), atLeft = valueAt(left);
        } else {
            low = left, left = right, atLeft = atRight;
            right = low + kGolden * (high - low), atRight = valueAt(right);
        }
    }
    return std::min({least, atLeft, atRight});
}

}  // namespace clearway::testing
