#include "problem/path_line.h"

#include <algorithm>

#include "clearway/errors.h"

namespace clearway {

PathLine::PathLine(std::vector<PartState> states, double turnRadius)
    : states_(std::move(states)), shares_(states_.size(), 0.0) {
    if (states_.empty()) throw ArgumentError("the path has no state, expected at least 1");
    for (std::size_t i = 1; i < states_.size(); ++i) {
        const PartState &a = states_[i - 1], &b = states_[i];
        shares_[i] = shares_[i - 1] + (b.position - a.position).norm() +
                     turnRadius * a.rotation.angularDistance(b.rotation);
    }
    const double length = shares_.back();
    for (double& share : shares_) share = length > 0 ? share / length : 0;
}

PartState PathLine::at(double share) const {
    const auto after = std::upper_bound(shares_.begin(), shares_.end(), share);
    if (after == shares_.begin()) return states_.front();
    if (after == shares_.end()) return states_.back();
    const auto b = static_cast<std::size_t>(after - shares_.begin());
    const double t = (share - shares_[b - 1]) / (shares_[b] - shares_[b - 1]);
    const PartState &from = states_[b - 1], &to = states_[b];
    return {from.position + t * (to.position - from.position),
            from.rotation.slerp(t, to.rotation).normalized()};
}

std::vector<double> evenShares(std::size_t count) {
    std::vector<double> shares(count, 0.0);
    for (std::size_t i = 1; i < count; ++i)
        shares[i] = static_cast<double>(i) / static_cast<double>(count - 1);
    return shares;
}

}  // namespace clearway
