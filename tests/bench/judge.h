// Judges the answers: where the series of a scene do not all agree, the oracle decides.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bench/bench_scenes.h"
#include "bench/series.h"

namespace clearway::testing {

/// The true distance at a pose, 0 exactly for contact.
using Referee = std::function<double(std::size_t pose)>;

/// The oracle, made when it is first asked, because most runs need it seldom. The task must outlive it.
Referee lazyOracle(const BenchTask& task);

struct Judgement {
    std::vector<double> distances;  ///< the true distance of each pose
    std::vector<bool> byOracle;     ///< whether the referee decided; otherwise all agree on clearway's answer
    std::vector<int> wrong;         ///< number of wrong answers of each series
    std::vector<std::string> complaints;  ///< a line for each wrong answer of clearway

    int collidingPoses() const;
    int askedPoses() const;  ///< the number of poses that the referee was asked about
};

/// A distance is wrong if it is off by more than `tolerance`, or if clearway's interval misses the true
/// distance by more. A verdict is wrong if the true distance contradicts it by more than `tolerance`; "free"
/// at contact is always wrong. Clearway's verdicts must also agree with its own distance, without tolerance.
/// The referee is asked at each pose where any series differs from clearway's first distance series, and at
/// `refereed` further poses spread over the set.
Judgement judge(const std::vector<Series>& all, std::size_t poses, double tolerance, const Referee& referee,
                std::size_t refereed);

}  // namespace clearway::testing
