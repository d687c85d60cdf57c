// Who is right: where the series of a scene do not all agree, the oracle decides.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bench/series.h"

namespace clearway::testing {

/// The true distance at a pose, 0 exactly for contact.
using Referee = std::function<double(std::size_t pose)>;

struct Judgement {
    std::vector<double> distances;  ///< true distance of each pose
    std::vector<bool> byOracle;     ///< whether the referee said so; else all agree on clearway's answer
    std::vector<int> wrong;         ///< answers of each series that are wrong
    std::vector<std::string> complaints;  ///< a line for each wrong answer of clearway

    int collidingPoses() const;
    int askedPoses() const;  ///< of the referee
};

/// A distance is wrong when it is off by more than `tolerance`, or clearway's interval misses the true one by
/// more; a verdict when the true distance contradicts it by more, but "free" always when there is contact.
/// Clearway's verdicts must also agree with its own distance, without tolerance. The referee is asked where
/// any series differs from clearway's first distance series, and at `refereed` poses spread over the set
/// besides.
Judgement judge(const std::vector<Series>& all, std::size_t poses, double tolerance, const Referee& referee,
                std::size_t refereed);

}  // namespace clearway::testing
